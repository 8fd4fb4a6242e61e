// The data of a running scene: the particles of its phases, its couplings, the neighbour lists. The layers above work
// on it: neighbourhood.hpp, motion.hpp, scene_engine.hpp.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/error.hpp>
#include <imbibe/search/stencils.hpp>
#include <imbibe/solver/seen.hpp>

#include <limits>

namespace imbibe::detail {

/// The neighbours of one phase's particles among those of another, or of its own.
struct IMBIBE_PER_BUILD Link {
    LinkRow row;
    search::RunList runs;
    search::RunList stencils; ///< of reference neighbours; see search::FixedLists
    double support = 0;       ///< m
    /// Distance of the nearest pair, m, if a term asks for it (TimeStepInput::nearest).
    double nearest = std::numeric_limits<double>::infinity();
    long long sweeps = 0; ///< number of sweeps over these neighbours
};

/// The origin of a scene's coordinates, m.
template <int dim>
using Origin = std::array<double, static_cast<std::size_t>(dim)>;

template <int dim, class Real>
class IMBIBE_PER_BUILD SceneStore {
public:
    using Phase = PhaseStore<dim, Real>;
    static constexpr int dimension = dim, width = native_width<Real>;

    SceneTable table;
    std::span<const Reduction<dim, Real>> reductions;
    std::vector<Phase> phases;
    std::vector<Seen<dim, Real>> seen; ///< of those that keep their reference order
    std::vector<std::any> couplings;   ///< an object of each one's type
    std::vector<std::string> coupling_names;
    std::vector<Link> links;

    Vector<double, dim> gravity{};
    /// The velocity of the frame in which speeds are measured, m/s: what limits a step is how fast particles move
    /// relative to each other, not a common motion. See Neighbourhood::choose_frame.
    Vector<double, dim> frame{};
    search::Periodic<dim> periodic;
    /// The displacements of the periodic images of the scene, m.
    std::array<Vector<Real, dim>, static_cast<std::size_t>(search::image_count<dim>)> images{};
    int threads = 1;

    SceneStore(const SceneTable& of, std::span<const Reduction<dim, Real>> of_terms);

    void set_periodic(const search::Periodic<dim>& sides);

    Phase& phase(int k) { return phases[static_cast<std::size_t>(k)]; }
    const Phase& phase(int k) const { return phases[static_cast<std::size_t>(k)]; }
    /// The points of a phase as others see it: in the order of the cells.
    search::Points<dim, Real> seen_points(int k) const {
        const Phase& s = phase(k);
        if (!s.row->keeps_reference())
            return s.points();
        search::Points<dim, Real> p{.n = s.size()};
        for (int d = 0; d < dim; ++d)
            p.x[static_cast<std::size_t>(d)] = seen_of(k).column(s.row->position + d);
        return p;
    }
    Seen<dim, Real>& seen_of(int k) { return seen[static_cast<std::size_t>(k)]; }
    const Seen<dim, Real>& seen_of(int k) const { return seen[static_cast<std::size_t>(k)]; }
    Link& link_at(int k) { return links[static_cast<std::size_t>(k)]; }
    const Link& link_at(int k) const { return links[static_cast<std::size_t>(k)]; }

    /// H between two phases: that of the fluid, so that its sums over both sides have the same reach; the greater one
    /// of two fluids, or if neither is a fluid.
    double support(int a, int b) const;
    /// The reach of the terms that sum over the neighbours of a link, m; see LinkRow.
    double support_of(const LinkRow& row) const;
    /// The longest reach of any term between two phases over present neighbours, m; at least their support().
    double longest_support(int a, int b) const;
    bool any_periodic() const {
        return std::any_of(periodic.length.begin(), periodic.length.end(), [](double length) { return length > 0; });
    }
    /// The particles of all phases, for checkpoints: their numbers first, so that a file that cannot hold them is
    /// detected before anything changes.
    template <class Archive>
    void archive_particles(Archive& a) {
        std::vector<std::uint64_t> counts;
        std::uint64_t bytes = 0;
        for (const Phase& s : phases) {
            std::uint64_t& count = counts.emplace_back(static_cast<std::uint64_t>(s.size()));
            a(count);
            if constexpr (Archive::reading) {
                require(count < (std::uint64_t{1} << 31), "checkpoint: phase ", s.name, " has ", count,
                        " particles; at most 2^31 - 1 are possible");
                bytes += count * s.bytes_per_archived_particle();
            }
        }
        if constexpr (Archive::reading) {
            a.need(bytes, 1);
            Archive ahead = a;
            for (std::size_t k = 0; k < phases.size(); ++k)
                phases[k].check_archived(ahead, counts[k]);
        }
        for (std::size_t k = 0; k < phases.size(); ++k)
            phases[k].archive(a, static_cast<int>(counts[k]));
    }
    /// The state of the next time step besides the particles.
    template <class Archive>
    void archive_motion(Archive& a) {
        for (Phase& s : phases)
            a(s.motion);
        a(frame);
        for (Phase& s : phases) {
            a(s.bounds.lower);
            a(s.bounds.upper);
        }
        for (Link& link : links)
            a(link.nearest);
    }
    std::size_t particle_bytes() const {
        std::size_t sum = 0;
        for (const Phase& s : phases)
            sum += s.bytes();
        for (const auto& copy : seen)
            sum += copy.bytes();
        return sum;
    }
    std::size_t list_bytes() const {
        std::size_t sum = 0;
        for (const Link& link : links)
            sum += link.runs.bytes() + link.stencils.bytes();
        return sum;
    }
};

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/scene_store_code.hpp>
#endif
