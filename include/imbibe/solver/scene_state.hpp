// All that a running scene consists of: the particles of its phases, its couplings, the neighbour lists and how fast
// each phase moves. What is done with it is in the layers above: neighbourhood.hpp, motion.hpp, engine.hpp.
#pragma once

#include <imbibe/solver/state.hpp>

#include <limits>

namespace imbibe::detail {

/// The neighbours of phase A's particles among those of phase B.
template <class A_, class B_, bool reference_>
struct IMBIBE_PER_BUILD Link {
    using A = A_;
    using B = B_;
    static constexpr bool reference = reference_;
    search::RunList runs;
    double support = 0; ///< m
    /// Distance of the nearest pair, m, where a term asks for it (TimeStepInput::nearest).
    double nearest = std::numeric_limits<double>::infinity();
    long long sweeps = 0; ///< how often terms were summed over these neighbours
};

template <int dim, class List>
struct LinksOf;
template <int dim, class... N>
struct LinksOf<dim, TypeList<N...>> {
    using type =
        Unique<Concat<std::conditional_t<is_pair_node<dim, N>,
                                         TypeList<Link<typename N::A, typename N::B, N::reference>>, TypeList<>>...>>;
};

/// How fast a phase moves.
struct Motion {
    double speed = 0;             ///< the greatest speed in the scene's frame (SceneState::frame), m/s
    double acceleration = 0;      ///< the greatest acceleration, m/s^2
    double fastest = 0;           ///< the greatest of the velocities as they are, m/s
    std::array<double, 3> mean{}; ///< of the velocities, m/s
};

/// @tparam Scene a Composition
template <int dim, class Real, class Scene>
class IMBIBE_PER_BUILD SceneState {
public:
    static constexpr int dimension = dim, width = native_width<Real>;
    template <class P>
    using FieldsOf = typename Scene::template FieldsOf<P>;
    template <class P>
    using State = PhaseState<P, FieldsOf<P>, dim, Real>;
    using Phases = typename Scene::Phases;
    using Couplings = typename Scene::Couplings;
    using Links = typename LinksOf<dim, typename Scene::Nodes>::type;

    Vector<double, dim> gravity{};
    /// The velocity of the frame in which speeds are measured, m/s: what limits a step is how fast particles move
    /// against each other, not how fast all move together. See Neighbourhood::choose_frame.
    Vector<double, dim> frame{};
    search::Periodic<dim> periodic;
    int threads = 1;

    template <class P>
    State<P>& state() {
        return std::get<State<P>>(states);
    }
    template <class P>
    const State<P>& state() const {
        return std::get<State<P>>(states);
    }
    template <class C>
    C& coupling() {
        return std::get<C>(couplings);
    }
    template <class C>
    const C& coupling() const {
        return std::get<C>(couplings);
    }
    template <class A, class B, bool reference>
    Link<A, B, reference>& link() {
        return std::get<Link<A, B, reference>>(links);
    }
    template <class A, class B, bool reference>
    const Link<A, B, reference>& link() const {
        return std::get<Link<A, B, reference>>(links);
    }
    template <class P>
    const Motion& motion() const {
        return motions[static_cast<std::size_t>(Scene::template phase_index<P>)];
    }
    /// H between two phases: that of the fluid, so that what pushes it from two sides is summed over the same reach;
    /// the greater one of two fluids, and where none is.
    template <class A, class B>
    double support() const {
        const double a = state<A>().material.support_radius, b = state<B>().material.support_radius;
        if constexpr (is_fluid<A> != is_fluid<B>)
            return is_fluid<A> ? a : b;
        else
            return std::max(a, b);
    }
    /// Calls f(state) for every phase.
    template <class F>
    void for_each_phase(const F& f) {
        each_phase(f, Phases{});
    }
    template <class F>
    void for_each_phase(const F& f) const {
        each_phase(f, Phases{});
    }

    /// Calls f(link) for every pair of phases that have neighbours in each other.
    template <class F>
    void for_each_link(const F& f) const {
        std::apply([&](const auto&... link) { (f(link), ...); }, links);
    }
    /// The same, to change them.
    template <class F>
    void for_each_link(const F& f) {
        std::apply([&](auto&... link) { (f(link), ...); }, links);
    }
    bool any_periodic() const {
        return std::any_of(periodic.length.begin(), periodic.length.end(), [](double length) { return length > 0; });
    }
    /// The particles of all phases, for checkpoints: their numbers first, so that a file that cannot hold them is
    /// noticed before anything changes.
    template <class Archive>
    void archive_particles(Archive& a) {
        std::array<std::uint64_t, static_cast<std::size_t>(Phases::size)> counts{};
        std::uint64_t bytes = 0;
        std::size_t k = 0;
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            counts[k] = static_cast<std::uint64_t>(s.size());
            a(counts[k]);
            if constexpr (Archive::reading) {
                require(counts[k] < (std::uint64_t{1} << 31), "checkpoint: phase ", type_name<P>(), " has ", counts[k],
                        " particles; at most 2^31 - 1 are possible");
                bytes += counts[k] * State<P>::bytes_per_archived_particle;
            }
            ++k;
        });
        if constexpr (Archive::reading)
            a.need(bytes, 1);
        k = 0;
        for_each_phase(
            [&]<class P>(std::type_identity<P>, State<P>& s) { s.archive(a, static_cast<int>(counts[k++])); });
    }
    /// What the next time step depends on besides the particles.
    template <class Archive>
    void archive_motion(Archive& a) {
        a(motions);
        a(frame);
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            a(s.bounds.lower);
            a(s.bounds.upper);
        });
        for_each_link([&](auto& link) { a(link.nearest); });
    }
    std::size_t particle_bytes() const {
        std::size_t sum = 0;
        for_each_phase([&]<class P>(std::type_identity<P>, const State<P>& s) { sum += s.bytes(); });
        return sum;
    }
    std::size_t list_bytes() const {
        std::size_t sum = 0;
        std::apply([&](const auto&... link) { ((sum += link.runs.bytes()), ...); }, links);
        return sum;
    }

protected:
    std::array<Motion, static_cast<std::size_t>(Phases::size)> motions{};

private:
    template <class List>
    struct StatesOf;
    template <class... P>
    struct StatesOf<TypeList<P...>> {
        using type = std::tuple<State<P>...>;
    };
    typename StatesOf<Phases>::type states;
    typename TupleOf<typename Scene::Couplings>::type couplings;
    typename TupleOf<Links>::type links;

    template <class F, class... P>
    void each_phase(const F& f, TypeList<P...>) {
        (f(std::type_identity<P>{}, state<P>()), ...);
    }
    template <class F, class... P>
    void each_phase(const F& f, TypeList<P...>) const {
        (f(std::type_identity<P>{}, state<P>()), ...);
    }
};

} // namespace imbibe::detail
