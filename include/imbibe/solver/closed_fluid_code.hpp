// The code of closed_fluid.hpp: keeps the volume.
#pragma once

#include <imbibe/solver/closed_fluid.hpp>

namespace imbibe::detail {

template <int dim, class Real>
double box_of(const SceneStore<dim, Real>& scene, int phase) {
    double box = 1;
    for (const double length : scene.periodic.length)
        box *= length;
    for (const auto& s : scene.phases)
        if (&s != &scene.phase(phase) && s.size() > 0)
            box = 0;
    return box;
}

template <int dim, class Real>
void keep_volume(PhaseStore<dim, Real>& s, const Real* before, double dt, double box, int threads) {
    if (box == 0 || dt == 0)
        return;
    struct Volumes {
        double before = 0, after = 0;
    };
    const Real* const m = s.column(s.row->mass);
    Real* const rate = s.column(s.row->density_rate);
    const auto sum = [&](int begin, int end) {
        Volumes sums;
        for (int i = begin; i < end; ++i) {
            const double rho = static_cast<double>(before[i]), mass_of_it = static_cast<double>(m[i]);
            sums.before += mass_of_it / rho;
            sums.after += mass_of_it / (rho + dt * static_cast<double>(rate[i]));
        }
        return sums;
    };
    const Volumes all =
        parallel_reduce(s.size(), threads, Volumes{}, sum, [](const Volumes& one, const Volumes& other) {
            return Volumes{one.before + other.before, one.after + other.after};
        });
    if (!(std::abs(all.before / box - 1) < 0.02) || !std::isfinite(all.after))
        return;
    const double f = all.after / all.before;
    const auto change = [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            rate[i] =
                static_cast<Real>(f * static_cast<double>(rate[i]) + (f - 1) / dt * static_cast<double>(before[i]));
    };
    loop_blocks(s.size(), 4096, threads, Callable<void(int, int)>(change));
}

template <int dim, class Real>
double greatest_relative_speed(const PhaseStore<dim, Real>& s) {
    const auto velocities = s.points_of(s.row->velocity);
    double speed2 = 0;
    std::array<double, static_cast<std::size_t>(dim)> mean{};
    for (std::size_t d = 0; d < mean.size(); ++d)
        for (int i = 0; i < s.size(); ++i)
            mean[d] += static_cast<double>(velocities.x[d][i]) / s.size();
    for (int i = 0; i < s.size(); ++i) {
        double one2 = 0;
        for (std::size_t d = 0; d < mean.size(); ++d)
            one2 += sq(static_cast<double>(velocities.x[d][i]) - mean[d]);
        speed2 = std::max(speed2, one2);
    }
    return std::sqrt(speed2);
}

template <int dim, class Real>
std::string warning_of_no_shifting(const SceneStore<dim, Real>& scene, int phase) {
    const auto& s = scene.phase(phase);
    const PhaseRow& row = *s.row;
    const double box = box_of(scene, phase);
    if (!row.fluid || row.density < 0 || row.velocity < 0 || row.transport_correction >= 0 || s.size() == 0 || box == 0)
        return {};
    double volume = 0;
    for (int i = 0; i < s.size(); ++i)
        volume += static_cast<double>(s.column(row.mass)[i]) / static_cast<double>(s.column(row.density)[i]);
    if (volume > 0.98 * box && greatest_relative_speed(s) > 0.02 * s.numbers().sound_speed)
        return text(s.name, " flows in a box that is periodic on all sides, and no term of it keeps its particles ",
                    "evenly spread: they line up along streamlines, voids open between them, and the flow loses ",
                    "energy. List ParticleShifting, from a lattice with strength = 4 and the speed of the flow for ",
                    "least_speed");
    return {};
}

} // namespace imbibe::detail
