// Measures pair terms alone in a sweep: about 50,000 particles with a support of 2.6 spacings, one thread, float. (All
// terms, as parts of a step, are in effects.cpp.) What particle functions prepare is set once and not measured. Terms of
// couplings are measured between two phases whose particles stand between each other, for the one that receives.
// Counters: `particle` and `neighbour`, the time per particle and per neighbour within the support. Run it:
//
//   build-benchmark/benchmarks/bench_terms
#include "support/alone.hpp"
#include "support/block.hpp"
#include "support/measure.hpp"

#include <imbibe/imbibe.hpp>

namespace {

using namespace imbibe;
using K = WendlandC2;
using Real = float;
constexpr int particles = 50'000;

struct Result {
    double receivers, neighbours;
};

/// A part on the particles of one phase.
template <template <class...> class Phase, class Part>
struct Within {
    struct Matter : bench::Alone<Phase, Part> {};
    using Scene = Solver<3, Real, SymplecticEuler, Matter>;
    using Rounds = std::conditional_t<imbibe::detail::is_once<Part>, typename Scene::Scene::Once,
                                      typename Scene::Scene::WholeStep>;

    static Matter matter() {
        if constexpr (requires(Matter m) { m.shear_modulus; })
            return Matter{{.density = 1000, .sound_speed = 30, .shear_modulus = 3e5}};
        else
            return Matter{{.density = 1000, .sound_speed = 30, .viscosity = 1e-3}};
    }
    static void add_to(Scene& scene) {
        bench::stir(scene[scene.add(matter(), bench::cube(particles), bench::spacing)], bench::spacing);
    }
    static double receivers(const typename Scene::Engine& engine) { return engine.template state<Matter>().size(); }
};

/// A part on the particles of one phase with neighbours of another.
template <template <class...> class Phase, template <class...> class OtherPhase, class Part>
struct Between {
    struct Matter : bench::ReadBy<Phase, Part> {};
    struct Other : bench::ReadBy<OtherPhase, Part> {};
    struct Meeting : Coupling<Matter, Other, Into<Matter, bench::detail::OnlyPart<Part>>> {};
    using Scene = Solver<3, Real, SymplecticEuler, Matter, Other, Meeting>;
    using Rounds = typename Scene::Scene::WholeStep;

    static void add_to(Scene& scene) {
        auto points = bench::cube(particles);
        scene.add(Matter{{.density = 1000, .sound_speed = 30, .viscosity = 1e-3}}, points, bench::spacing);
        for (auto& x : points)
            x.array() += 0.5 * bench::spacing;
        scene.add(Other{{.density = 1000, .sound_speed = 30, .viscosity = 1e-3}}, points, bench::spacing);
    }
    static double receivers(const typename Scene::Engine& engine) { return engine.template state<Matter>().size(); }
};

template <class Case>
void alone(benchmark::State& state) {
    typename Case::Scene scene({.gravity = {0, 0, -9.81}, .support_radius = 2.6 * bench::spacing, .threads = 1});
    Case::add_to(scene);
    scene.prepare();
    auto engine = scene.engine();
    for (auto _ : state)
        engine.template run<typename Case::Rounds>(0);
    const double receivers = Case::receivers(engine), neighbours = bench::neighbours_in(engine);
    bench::per_item(state, "particle", receivers);
    bench::per_item(state, "neighbour", receivers * neighbours);
}

} // namespace

#define WITHIN(phase, name, ...) BENCHMARK(alone<Within<phase, __VA_ARGS__>>)->Name(name)
#define BETWEEN(phase, other, name, ...) BENCHMARK(alone<Between<phase, other, __VA_ARGS__>>)->Name(name)

WITHIN(Fluid, "Continuity", Continuity<K>);
WITHIN(Fluid, "VolumeContinuity", VolumeContinuity<K>::Sweep);
WITHIN(Fluid, "DensityDiffusion", DensityDiffusion<K>::Smooth);
WITHIN(Fluid, "SymmetricPressure", SymmetricPressure<K>::Push);
WITHIN(Fluid, "VolumePressure", VolumePressure<K>::Push);
WITHIN(Fluid, "LaminarViscosity", LaminarViscosity<>);
WITHIN(Fluid, "MorrisViscosity", MorrisViscosity<K>);
WITHIN(Fluid, "MonaghanViscosity", MonaghanViscosity<K>);
WITHIN(Solid, "VelocityGradient", VelocityGradient<K>);
WITHIN(Solid, "StressForce", StressForce<K>::Push);
WITHIN(Solid, "ArtificialStress", ArtificialStress<K>::Push);
WITHIN(Solid, "Xsph", Xsph<Poly6>::Sum);
WITHIN(Solid, "ReferenceCorrection (once)", ReferenceCorrection<K>::Moments);
WITHIN(Solid, "DeformationGradient", DeformationGradient<K>::Sum);
WITHIN(Solid, "TotalLagrangianForce", TotalLagrangianForce<K>::Push);
WITHIN(Solid, "HourglassControl", HourglassControl<K>::Push);
WITHIN(Solid, "TotalLagrangianViscosity", TotalLagrangianViscosity<K>::Push);
BETWEEN(Fluid, Wall, "KernelRepulsion", KernelRepulsion<Spiky>);
BETWEEN(Wall, Fluid, "PressureExtrapolation", PressureExtrapolation<K>::Sum);
BETWEEN(Wall, Fluid, "NoSlipVelocity", NoSlipVelocity<K>::Sum);
BETWEEN(Fluid, Wall, "NoSlipViscosity", NoSlipViscosity<K>);

BENCHMARK_MAIN();
