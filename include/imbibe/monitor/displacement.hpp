// How far the particles of a phase have moved since a chosen time.
#pragma once

#include <imbibe/solver/solver.hpp>

namespace imbibe {

/// Stores the positions of the particles of a phase, by number, and measures displacements from there; for any solid,
/// total Lagrangian or not. Not for phases from which particles are removed and to which others are added. Throws Error
/// for a particle that was not there at the start.
///
/// In a periodic box, particles that leave on one side come back on the other, except those of total-Lagrangian solids,
/// whose positions continue beyond it. A probe that knows the scene's settings measures across that side, as long as no
/// particle has moved by half a period; without them a particle that came back seems to have moved by a period.
template <int dim>
class DisplacementProbe {
public:
    /// Measures from the present positions: `DisplacementProbe<3> probe(scene[sponge])`; in a periodic scene,
    /// `DisplacementProbe<3> probe(scene[sponge], scene.settings())`.
    template <class View>
    explicit DisplacementProbe(const View& phase, const Settings<dim>& settings = {})
        : start(static_cast<std::size_t>(phase.size())) {
        if constexpr (!std::remove_cvref_t<decltype(phase.state)>::keeps_reference)
            period = settings.periodic_length;
        const auto x = phase[position];
        for (int i = 0; i < phase.size(); ++i) {
            const std::size_t id = phase.ids()[static_cast<std::size_t>(i)];
            require(id < start.size(), "DisplacementProbe: particle ", id, " of a phase with ", start.size(),
                    " particles; it is not for phases from which particles were removed");
            start[id] = x.row(i).transpose().template cast<double>();
        }
    }
    /// The mean of |x_a - x_a(0)|, m: the paper's average displacement, with the length of the vector.
    template <class View>
    double mean(const View& phase) const {
        double total = 0;
        each(phase, [&](const Eigen::Matrix<double, dim, 1>& u) { total += u.norm(); });
        return total / phase.size();
    }
    /// The mean of x_a - x_a(0), m.
    template <class View>
    Eigen::Matrix<double, dim, 1> mean_vector(const View& phase) const {
        Eigen::Matrix<double, dim, 1> total = Eigen::Matrix<double, dim, 1>::Zero();
        each(phase, [&](const Eigen::Matrix<double, dim, 1>& u) { total += u; });
        return total / phase.size();
    }
    /// The same over the particles that started where `chosen(x)` is true, with positions as in the view.
    template <class View, class Chosen>
    Eigen::Matrix<double, dim, 1> mean_vector(const View& phase, const Chosen& chosen) const {
        Eigen::Matrix<double, dim, 1> total = Eigen::Matrix<double, dim, 1>::Zero();
        int count = 0;
        each(phase, [&](const Eigen::Matrix<double, dim, 1>& u, const Eigen::Matrix<double, dim, 1>& from) {
            if (chosen(from)) {
                total += u;
                ++count;
            }
        });
        require(count > 0, "displacements of a part of a phase: no particle started in that part");
        return total / count;
    }
    /// The greatest |x_a - x_a(0)|, m.
    template <class View>
    double greatest(const View& phase) const {
        double most = 0;
        each(phase, [&](const Eigen::Matrix<double, dim, 1>& u) { most = std::max(most, u.norm()); });
        return most;
    }

private:
    template <class View, class F>
    void each(const View& phase, const F& f) const {
        const auto x = phase[position];
        require(phase.size() == static_cast<int>(start.size()), "displacements are measured from ", start.size(),
                " particles, but there are ", phase.size(),
                " now; make the probe anew when particles were added or removed");
        for (int i = 0; i < phase.size(); ++i) {
            const std::size_t id = phase.ids()[static_cast<std::size_t>(i)];
            require(id < start.size(), "displacements: particle ", id,
                    " was not there when the probe was made; make it anew when particles were added or removed");
            const auto& from = start[id];
            Eigen::Matrix<double, dim, 1> u = x.row(i).transpose().template cast<double>() - from;
            for (int d = 0; d < dim; ++d)
                if (const double length = period[static_cast<std::size_t>(d)]; length > 0)
                    u[d] -= length * std::round(u[d] / length);
            if constexpr (requires { f(u, from); })
                f(u, from);
            else
                f(u);
        }
    }
    std::vector<Eigen::Matrix<double, dim, 1>> start;
    std::array<double, static_cast<std::size_t>(dim)> period{}; ///< m; 0: positions do not come back
};

} // namespace imbibe
