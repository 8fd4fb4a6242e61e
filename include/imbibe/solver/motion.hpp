// How particles move: velocities by accelerations, positions by velocities, and how fast that is.
#pragma once

#include <imbibe/solver/closed_fluid.hpp>
#include <imbibe/solver/neighbourhood.hpp>

namespace imbibe::detail {

/// What SupportedShare is made of, in one step.
template <int dim, class Real>
class Support {
public:
    Support() = default;
    /// @param g of the scene, m/s^2
    /// @param sound how far sound comes in the step, in support radii
    Support(const Vector<double, dim>& g, double sound)
        : follow(static_cast<Real>(std::clamp(sound / supports, 0.0, 1.0))) {
        const double g2 = squared_norm(g);
        for (int d = 0; d < dim; ++d) {
            gravity[d] = static_cast<Real>(g[d]);
            per_weight[d] = g2 > 0 ? static_cast<Real>(g[d] / g2) : Real(0);
        }
    }
    /// What component d of an acceleration adds to (g - a).g/|g|^2.
    IMBIBE_INLINE Real along(std::size_t d, Real a) const {
        const int k = static_cast<int>(d);
        return per_weight[k] * (gravity[k] - a);
    }
    /// The mean, and what it is after this step. It follows at once where nothing was supported: so water that stands
    /// is borne from its first step on, and no blow counts for more than its weight.
    IMBIBE_INLINE Real mean(Real before, Real now) const {
        return before == 0 ? std::min(std::max(now, Real(0)), Real(1)) : before + follow * (now - before);
    }

private:
    // Over how long it is a mean: as long as sound takes for so many support radii. Without it (0) sound would be felt
    // as support, and pass undamped by what smooths densities; with more, water that lands is taken for falling longer.
    static constexpr double supports = 10;
    Vector<Real, dim> gravity{}, per_weight{};
    Real follow = 0;
};
/// The same where no term reads it.
struct NoSupport {
    template <class Real>
    IMBIBE_INLINE Real along(std::size_t, Real) const {
        return Real(0);
    }
};

template <int dim, class Real, class Scene>
class IMBIBE_PER_BUILD Mover : public Neighbourhood<dim, Real, Scene> {
    using Base = Neighbourhood<dim, Real, Scene>;

public:
    template <class P>
    using FieldsOf = typename Base::template FieldsOf<P>;
    template <class P>
    using State = typename Base::template State<P>;
    using Base::for_each_phase;

    /// velocity += dt * acceleration, for what moves and is not held; measures the motion.
    void kick(double dt) { kick_if<Every>(dt); }
    /// position += dt * (velocity + transport correction), for what moves and is not held.
    void drift(double dt) { drift_if<Every>(dt); }
    /// The same for the phases with Chosen<P>::value.
    template <template <class> class Chosen>
    void kick_if(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves && Chosen<P>::value)
                measure(s, advance_velocities(s, s.field(velocity), dt));
        });
    }
    template <template <class> class Chosen>
    void drift_if(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves && Chosen<P>::value) {
                advance_positions(s, s.field(position), dt);
                note_way<P>(dt);
            }
        });
    }

    /// Keeps a copy of all that is integrated: positions, velocities, states. For integrators with several stages.
    void remember() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            auto& copy = std::get<Kept<P>>(kept).values;
            copy.resize(s.stride() * static_cast<std::size_t>(component_count<dim, KeptFields<P>>));
            copy_kept(s, copy, KeptFields<P>{});
        });
    }
    /// What was remembered, advanced by dt with the present rates (of positions: the present velocities).
    /// Neighbours and the order of the particles must not have changed since.
    void advance_remembered(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            auto& copy = std::get<Kept<P>>(kept).values;
            if constexpr (P::moves) { // positions first: they need the velocities as they are
                advance_positions(s, copy.data() + kept_offset<P, Position> * s.stride(), dt);
                note_way<P>(dt);
                measure(s, advance_velocities(s, copy.data() + kept_offset<P, Velocity> * s.stride(), dt));
            }
            advance_states(s, copy, dt, typename Scene::template AdvancedOf<P>{});
            s.pad();
            if constexpr (State<P>::keeps_reference)
                this->copy_places_to_image(s);
        });
    }

    /// to += by * (velocity + transport correction), a vector field of phase P: by how it moves, or is moved by a host.
    template <class P>
    void add_velocities(Real* to, double by) {
        const auto& s = this->template state<P>();
        const Real* v = s.field(velocity);
        for (std::size_t d = 0; d < dim; ++d)
            for (int i = 0; i < s.size(); ++i) {
                const std::size_t k = d * s.stride() + static_cast<std::size_t>(i);
                Real speed = v[k];
                if constexpr (contains<TransportCorrection, FieldsOf<P>>) {
                    Real free = 1;
                    if constexpr (contains<Mobility, FieldsOf<P>>)
                        free = s.field(mobility)[i];
                    speed += free * s.field(transport_correction)[k];
                }
                to[k] += static_cast<Real>(by) * speed;
            }
    }
    /// Keeps a copy of the sums on top of which the pass `What` acts: its columns `kept`.
    template <class What>
    void keep_sums() {
        for_each_kept<What>([&](auto& copy, const auto& s, int column, std::size_t at) {
            copy.resize(std::max(copy.size(), (at + 1) * s.stride()));
            copy_column(s.column(column), copy.data() + at * s.stride(), s.size());
        });
    }
    /// These sums as they were kept. The order of the particles must not have changed since.
    template <class What>
    void restore_sums() {
        for_each_kept<What>([&](const auto& copy, auto& s, int column, std::size_t at) {
            copy_column(copy.data() + at * s.stride(), s.column(column), s.size());
        });
    }

    /// Measures the speeds of every phase; its acceleration is at least gravity. For the first step.
    void measure_motion() {
        const auto measure_all = [&] {
            for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
                auto& m = this->motions[static_cast<std::size_t>(Scene::template phase_index<P>)];
                const double acceleration = std::max(m.acceleration, std::sqrt(squared_norm(this->gravity)));
                m = this->velocities_of(s);
                m.acceleration = acceleration;
            });
        };
        measure_all(); // the means, of which the frame is made
        this->choose_frame();
        measure_all();
    }

    /// The same for velocities that a host has made greater since the last step. Speeds that only differ in how they
    /// are rounded stay what they are: to look at a scene changes nothing.
    void notice_greater_speeds() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves) {
                auto& m = this->motions[static_cast<std::size_t>(Scene::template phase_index<P>)];
                const Motion now = this->velocities_of(s);
                if (now.speed > m.speed + 1e-5 * m.fastest || now.fastest > m.fastest * (1 + 1e-5)) {
                    m.speed = now.speed;
                    m.fastest = now.fastest;
                    m.mean = now.mean;
                }
            }
        });
    }

private:
    template <class P>
    struct Every : std::true_type {};

    // What is integrated of a phase.
    template <class P>
    using KeptFields = Concat<std::conditional_t<P::moves, TypeList<Position, Velocity>, TypeList<>>,
                              typename Scene::template AdvancedOf<P>>;
    template <class P, class F>
    static constexpr std::size_t kept_offset = static_cast<std::size_t>(component_offset<dim, F, KeptFields<P>>);
    template <class P>
    struct Kept {
        AlignedVector<Real> values, sums;
    };
    template <class List>
    struct AllKept;
    template <class... P>
    struct AllKept<TypeList<P...>> {
        using type = std::tuple<Kept<P>...>;
    };
    typename AllKept<typename Scene::Phases>::type kept;

    [[gnu::noinline]] void copy_column(const Real* from, Real* to, int n) {
        const auto block = [&](int begin, int end) { std::copy_n(from + begin, end - begin, to + begin); };
        loop_blocks(n, 4096, this->threads, Callable<void(int, int)>(block));
    }
    // Calls f(copy, state, column, k) for every column that the pass `What` keeps, the k-th of its phase.
    template <class What, class F>
    void for_each_kept(const F& f) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            std::size_t k = 0;
            [&]<class... G>(TypeList<G...>) { (columns_kept<What, P, G>(f, s, k), ...); }(FieldsOf<P>{});
        });
    }
    template <class What, class P, class G, class F>
    void columns_kept(const F& f, State<P>& s, std::size_t& k) {
        if constexpr (What::kept.test(Scene::template column<P, G>))
            for (int c = 0; c < components(G::rank, dim); ++c, ++k)
                f(std::get<Kept<P>>(kept).sums, s, State<P>::template offset<G> + c, k);
    }
    template <class S, class... F>
    void copy_kept(const S& s, AlignedVector<Real>& copy, TypeList<F...> list) {
        [[maybe_unused]] const auto one = [&]<class G>(std::type_identity<G>) {
            for (int k = 0; k < components(G::rank, dim); ++k)
                copy_column(s.column(S::template offset<G> + k),
                            copy.data() +
                                static_cast<std::size_t>(component_offset<dim, G, decltype(list)> + k) * s.stride(),
                            s.size());
        };
        (one(std::type_identity<F>{}), ...);
    }
    template <class P, class List, class... F>
    void advance_states(PhaseState<P, List, dim, Real>& s, const AlignedVector<Real>& from, double dt, TypeList<F...>) {
        const Real by = static_cast<Real>(dt);
        [[maybe_unused]] const auto one = [&]<class G>(std::type_identity<G>) {
            if constexpr (std::is_same_v<G, Density>)
                keep_volume(s, from.data() + kept_offset<P, G> * s.stride(), dt, box_of<P>(*this), this->threads);
            for (std::size_t k = 0; k < static_cast<std::size_t>(components(G::rank, dim)); ++k) {
                const int c = static_cast<int>(k);
                Real* to = s.column(component_offset<dim, G, List> + c);
                const Real* rate = s.column(component_offset<dim, Rate<G>, List> + c);
                const Real* old = from.data() + (kept_offset<P, G> + k) * s.stride();
                const auto block = [&](int begin, int end) {
                    for (int i = begin; i < end; ++i)
                        to[i] = old[i] + by * rate[i];
                };
                loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
            }
        };
        (one(std::type_identity<F>{}), ...);
    }

    // velocity = old + dt * acceleration; the speeds and the greatest acceleration; the supported share, if a term
    // reads it.
    template <class P, class List>
    Motion advance_velocities(PhaseState<P, List, dim, Real>& s, const Real* old, double dt) {
        const Real by = static_cast<Real>(dt);
        Real* v = s.field(velocity);
        const Real* a = s.field(acceleration);
        const std::size_t stride = s.stride();
        Real of_frame[static_cast<std::size_t>(dim)];
        for (int d = 0; d < dim; ++d)
            of_frame[d] = static_cast<Real>(this->frame[d]);
        std::conditional_t<contains<SupportedShare, List>, Support<dim, Real>, NoSupport> support;
        if constexpr (contains<SupportedShare, List>)
            support = {this->gravity, dt * s.material.sound_speed / s.material.support_radius};
        const auto block = [&](int begin, int end) {
            Real speed2 = 0, acceleration2 = 0, fastest2 = 0, sum[static_cast<std::size_t>(dim)]{};
            for (int i = begin; i < end; ++i) {
                Real free = 1, v2 = 0, relative2 = 0, a2 = 0, borne = 0;
                if constexpr (contains<Mobility, List>)
                    free = s.field(mobility)[i];
                for (std::size_t d = 0; d < dim; ++d) {
                    const std::size_t k = d * stride + static_cast<std::size_t>(i);
                    v[k] = old[k] + by * free * a[k];
                    v2 += v[k] * v[k];
                    relative2 += sq(v[k] - of_frame[d]);
                    sum[d] += v[k];
                    a2 += free * a[k] * a[k];
                    borne += support.along(d, free * a[k]);
                }
                if constexpr (contains<SupportedShare, List>)
                    s.field(supported_share)[i] = support.mean(s.field(supported_share)[i], borne);
                speed2 = std::max(speed2, relative2);
                fastest2 = std::max(fastest2, v2);
                acceleration2 = std::max(acceleration2, a2);
            }
            Motion found{std::sqrt(static_cast<double>(speed2)),
                         std::sqrt(static_cast<double>(acceleration2)),
                         std::sqrt(static_cast<double>(fastest2)),
                         {}};
            for (std::size_t d = 0; d < dim; ++d)
                found.mean[d] = static_cast<double>(sum[d]);
            return found;
        };
        return motion_of_blocks(s.size(), this->threads, Callable<Motion(int, int)>(block));
    }
    template <class P, class List>
    void measure(const PhaseState<P, List, dim, Real>&, const Motion& motion) {
        this->motions[static_cast<std::size_t>(Scene::template phase_index<P>)] = motion;
    }
    // With a transport correction it is not known how far it was: then neighbours are found anew in every step.
    template <class P>
    void note_way(double dt) {
        constexpr auto k = static_cast<std::size_t>(Scene::template phase_index<P>);
        if constexpr (contains<TransportCorrection, FieldsOf<P>>)
            this->travelled[k] = std::numeric_limits<double>::infinity();
        else
            this->travelled[k] += dt * this->motions[k].fastest;
    }
    // position = old + dt * (velocity + transport correction).
    template <class P, class List>
    void advance_positions(PhaseState<P, List, dim, Real>& s, const Real* old, double dt) {
        const auto block = [&](int begin, int end) {
            const Real by = static_cast<Real>(dt);
            for (int d = 0; d < dim; ++d) {
                Real* x = s.column(component_offset<dim, Position, List> + d);
                const Real* x0 = old + static_cast<std::size_t>(d) * s.stride();
                const Real* v = s.column(component_offset<dim, Velocity, List> + d);
                for (int i = begin; i < end; ++i) {
                    Real speed = v[i];
                    if constexpr (contains<TransportCorrection, List>)
                        speed += s.column(component_offset<dim, TransportCorrection, List> + d)[i];
                    if constexpr (contains<Mobility, List>)
                        speed *= s.field(mobility)[i];
                    x[i] = x0[i] + by * speed;
                }
            }
        };
        loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
    }
};

} // namespace imbibe::detail
