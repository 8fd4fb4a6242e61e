// The rounds that the compiler makes of the two sponges: how many sweeps, and what comes before what.
#include <imbibe/presets/sponge.hpp>

#include <catch_shim.hpp>

namespace rounds_test {

namespace {

using namespace imbibe;

// In which step of the plan the rows of part P on phase A are; -1 if in none.
template <class Scene, class P, class A>
int place() {
    const auto find = []<class... N>(TypeList<N...>) {
        const bool wanted[] = {[] {
            if constexpr (Scene::template is_advance<N>)
                return std::is_same_v<N, P> && std::is_same_v<typename N::A, A>;
            else
                return std::is_same_v<typename N::Part, P> && std::is_same_v<typename N::A, A>;
        }()...};
        for (int k = 0; k < Scene::plan.size; ++k) {
            const Step& step = Scene::plan.steps[static_cast<std::size_t>(k)];
            for (int r = 0; r < step.size; ++r)
                if (wanted[step.rows[static_cast<std::size_t>(r)]])
                    return k;
        }
        return -1;
    };
    return find(typename Scene::StepRows{});
}

} // namespace

TEST_CASE("The rounds of the paper's sponge", "[schedule]") {
    using Preset = presets::PaperSponge;
    using Water = Preset::Water;
    using Sponge = Preset::Sponge;
    using Vessel = Preset::Vessel;
    using Scene = Composition<3, Water, Sponge, Vessel, Preset::Contact, Preset::Sides>;
    CHECK(Scene::plan.fault == Fault::none);
    CHECK(Scene::once_plan.size == 0);
    // Density rates, then forces; the sponge's smoothed velocity comes before its gradient.
    CHECK(Scene::plan.sweeps(Scene::phase_index<Water>) == 2);
    CHECK(Scene::plan.sweeps(Scene::phase_index<Sponge>) == 3);
    CHECK(Scene::plan.sweeps(Scene::phase_index<Vessel>) == 1);

    const int xsph = place<Scene, Xsph<Poly6>::Sum, Sponge>();
    const int smooth = place<Scene, Xsph<Poly6>::Smooth, Sponge>();
    const int gradient = place<Scene, VelocityGradient<Spiky, smoothed_velocity>, Sponge>();
    const int continuity = place<Scene, Continuity<Spiky, smoothed_velocity>, Sponge>();
    const int jaumann = place<Scene, JaumannStress, Sponge>();
    const int stress = place<Scene, detail::Advance<Sponge, DeviatoricStress>, Sponge>();
    const int rho = place<Scene, detail::Advance<Sponge, Density>, Sponge>();
    const int state = place<Scene, LinearState, Sponge>();
    const int force = place<Scene, StressForce<Spiky>::Push, Sponge>();
    CHECK(0 <= xsph);
    CHECK(xsph < smooth);
    CHECK(smooth < gradient);
    CHECK(gradient == continuity); // one sweep
    CHECK(gradient < jaumann);
    CHECK(jaumann <= stress);
    CHECK(rho <= state);
    CHECK(std::max(stress, state) < force);
    CHECK(force == place<Scene, MonaghanViscosity<Spiky>, Sponge>());
    CHECK(force == place<Scene, KernelRepulsion<Spiky>, Sponge>());

    const int water_rate = place<Scene, Continuity<Spiky>, Water>();
    const int water_force = place<Scene, SymmetricPressure<Spiky>::Push, Water>();
    CHECK(0 <= water_rate);
    CHECK(water_rate < place<Scene, detail::Advance<Water, Density>, Water>());
    CHECK(place<Scene, Tait<7>, Water>() < water_force);
    CHECK(water_force == place<Scene, LaminarViscosity<ViscosityKernel>, Water>());
    // p/rho^2 of every phase that pushes is ready before the water is pushed.
    CHECK(place<Scene, SymmetricPressure<Spiky>::Prepare, Sponge>() < water_force);
    CHECK(place<Scene, SymmetricPressure<Spiky>::Prepare, Vessel>() < water_force);
    // The vessel does not move: no force on it is summed.
    CHECK(place<Scene, SymmetricPressure<Spiky>::Push, Vessel>() == -1);
    CHECK(place<Scene, KernelRepulsion<Spiky>, Vessel>() == -1);
}

TEST_CASE("The rounds of the sound sponge", "[schedule]") {
    using Preset = presets::SoundSponge;
    using K = Preset::K;
    using Water = Preset::Water;
    using Sponge = Preset::Sponge;
    using Vessel = Preset::Vessel;
    using Scene = Composition<3, Water, Sponge, Vessel, Preset::Contact, Preset::Sides>;
    CHECK(Scene::plan.fault == Fault::none);
    CHECK(Scene::plan.sweeps(Scene::phase_index<Water>) == 2);
    CHECK(Scene::plan.sweeps(Scene::phase_index<Sponge>) == 3);
    CHECK(Scene::plan.sweeps(Scene::phase_index<Vessel>) == 1);
    // The correction matrix, the stress share, and how large gradients are with them, are computed once, and not in
    // every step.
    CHECK(Scene::OnceRows::size == 4);
    CHECK(Scene::once_plan.size == 3); // share and matrix in one loop
    CHECK(place<Scene, ReferenceCorrection<K>::Moments, Sponge>() == -1);

    // The water's pressure, then its continuation to sponge and vessel, then the push of both on the water and back.
    const int state = place<Scene, LinearState, Water>();
    const int push = place<Scene, VolumePressure<K>::Push, Water>();
    const auto between = [&]<class P>(std::type_identity<P>) {
        const int sum = place<Scene, typename PressureExtrapolation<K>::Sum, P>();
        const int divide = place<Scene, typename PressureExtrapolation<K>::Divide, P>();
        CHECK(state < sum);
        CHECK(sum < divide);
        CHECK(divide < push);
    };
    CHECK(0 <= state);
    between(std::type_identity<Sponge>{});
    between(std::type_identity<Vessel>{});
    CHECK(place<Scene, VolumePressure<K>::Push, Sponge>() == place<Scene, TotalLagrangianForce<K>::Push, Sponge>());
    CHECK(place<Scene, DeformationGradient<K>::Sum, Sponge>() < place<Scene, CompressibleNeoHookean, Sponge>());
    // The sponge's density stays that of the stress-free solid; nothing of the paper's sponge is stored.
    CHECK_FALSE(detail::contains<Rate<Density>, Scene::FieldsOf<Sponge>>);
    CHECK_FALSE(detail::contains<DeviatoricStress, Scene::FieldsOf<Sponge>>);
    CHECK(Scene::keeps_reference<Sponge>);
    CHECK_FALSE(Scene::keeps_reference<Water>);
}

} // namespace rounds_test
