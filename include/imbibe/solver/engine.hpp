// The engine of a scene with named types: its phases, couplings and passes. scene_engine.hpp and below do the work.
#pragma once

#include <imbibe/solver/lowering.hpp>
#include <imbibe/solver/phase_state.hpp>
#include <imbibe/solver/scene_engine.hpp>

namespace imbibe::detail {

/// @tparam Scene a Composition
template <int dim, class Real, class Scene>
class IMBIBE_PER_BUILD Engine : public SceneEngine<dim, Real> {
    using Base = SceneEngine<dim, Real>;
    using Tables = Lowering<dim, Real, Scene>;
    template <class P>
    static constexpr int index = Scene::template phase_index<P>;

public:
    using Composition = Scene;
    using Phases = typename Scene::Phases;
    using Couplings = typename Scene::Couplings;
    using Links = typename Tables::Links;
    template <class P>
    using FieldsOf = typename Scene::template FieldsOf<P>;
    /// A phase to change, or to look at.
    template <class P>
    using State = PhaseState<P, FieldsOf<P>, PhaseStore<dim, Real>>;
    template <class P>
    using ConstState = PhaseState<P, FieldsOf<P>, const PhaseStore<dim, Real>>;

    Engine() : Base(Tables::scene, Tables::reductions) {}

    template <class P>
    State<P> state() {
        return State<P>(this->phase(index<P>));
    }
    template <class P>
    ConstState<P> state() const {
        return ConstState<P>(this->phase(index<P>));
    }
    template <class C>
    C& coupling() {
        return *std::any_cast<C>(&this->couplings[coupling_index<C>]);
    }
    template <class C>
    const C& coupling() const {
        return *std::any_cast<C>(&this->couplings[coupling_index<C>]);
    }
    template <class A, class B, bool reference, class Reach = void>
    const Link& link() const {
        return this->link_at(index_of<LinkType<A, B, reference, Reach>, Links>);
    }
    template <class P>
    const Motion& motion() const {
        return this->phase(index<P>).motion;
    }
    template <class P>
    Motion motion_now() const {
        return Base::motion_now(index<P>);
    }
    template <class A, class B>
    double support() const {
        return Base::support(index<A>, index<B>);
    }
    template <class A, class B>
    bool are_apart() const {
        return Base::are_apart(index<A>, index<B>);
    }
    template <class C>
    double nearest_of() const {
        return this->nearest_of_coupling(static_cast<int>(coupling_index<C>));
    }
    /// Calls f(std::type_identity<P>, its state) for every phase.
    template <class F>
    void for_each_phase(const F& f) {
        [&]<class... P>(TypeList<P...>) { (f(std::type_identity<P>{}, state<P>()), ...); }(Phases{});
    }
    template <class F>
    void for_each_phase(const F& f) const {
        [&]<class... P>(TypeList<P...>) { (f(std::type_identity<P>{}, state<P>()), ...); }(Phases{});
    }
    /// Calls f(LinkType, its Link) for every pair of phases that have neighbours in each other.
    template <class F>
    void for_each_link(const F& f) const {
        [&]<class... L>(TypeList<L...>) { (f(L{}, this->link_at(index_of<L, Links>)), ...); }(Links{});
    }

    // ---- for integrators ----
    /// Evaluates terms in the order of their plan. `dt` is by how much states are advanced, s.
    /// @tparam What which terms: one of Composition::WholeStep, Rates, ...
    template <class What>
    void run(double dt) {
        if constexpr (Scene::valid)
            Base::run(Tables::template pass<What>(), dt);
        else
            nothing<Scene>(); // that has an error: its loops would have more, and it must not link without them
    }
    /// The same for phases that have grown, and those that sum over them.
    template <class What>
    void run_for_grown() {
        if constexpr (Scene::valid)
            Base::run_for_grown(Tables::template pass<What>());
    }
    /// Keeps a copy of the sums to which the pass `What` adds.
    template <class What>
    void keep_sums() {
        Base::keep_sums(Tables::template pass<What>().kept);
    }
    /// Restores these sums. The order of the particles must not have changed since.
    template <class What>
    void restore_sums() {
        Base::restore_sums(Tables::template pass<What>().kept);
    }
    /// `kick` and `drift` for the phases with Chosen<P>::value.
    template <template <class> class Chosen>
    void kick_if(double dt) {
        this->kick(dt, chosen<Chosen>(Phases{}));
    }
    template <template <class> class Chosen>
    void drift_if(double dt) {
        this->drift(dt, chosen<Chosen>(Phases{}));
    }
    template <class P>
    void refresh_places_among() {
        Base::refresh_places_among(index<P>);
    }
    /// to += by * (velocity + transport correction), a vector field of phase P.
    template <class P>
    void add_velocities(Real* to, double by) const {
        Base::add_velocities(this->phase(index<P>), to, by);
    }

private:
    template <class C>
    static constexpr auto coupling_index = static_cast<std::size_t>(index_of<C, Couplings>);
    template <template <class> class Chosen, class... P>
    static constexpr Bits chosen(TypeList<P...>) {
        Bits phases;
        ((Chosen<P>::value ? phases.set(index<P>) : void()), ...);
        return phases;
    }
};

} // namespace imbibe::detail
