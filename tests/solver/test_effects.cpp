// Nothing for what is off: what compositions store, compute and load, as constants, and what a scene then takes.
#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/velocity_gradient.hpp>
#include <imbibe/solid/xsph.hpp>
#include <imbibe/solver/costs.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/predictor_corrector.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <catch_shim.hpp>

namespace effects_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Inviscid : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
struct Viscous : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MonaghanViscosity<K>> {};
struct Smoothed : sph::Fluid<sph::Tait<>, sph::Continuity<K>, sph::SymmetricPressure<K>, sph::MonaghanViscosity<K>,
                             sph::Xsph<K>, sph::XsphTransport> {};
struct Tank : sph::Wall<> {};
struct Sides : sph::Coupling<Viscous, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::SymmetricPressure<K>> {
};
struct Rubber : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::VelocityGradient<K>, sph::JaumannStress,
                           sph::StressForce<K>> {};
struct Rings : sph::Solid<sph::LinearState, sph::Continuity<K>, sph::VelocityGradient<K>, sph::JaumannStress,
                          sph::StressForce<K>, sph::ArtificialStress<K>> {};
struct Plate : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>> {};
struct Contact : sph::Coupling<Viscous, Plate, sph::KernelRepulsion<K>> {};

template <class... Items>
using Scene = sph::Composition<3, Items...>;
template <class... Items>
using Costs = sph::Costs<Scene<Items...>>;

/// Is the term among those that are computed?
template <class Term, class Composition>
constexpr bool computes = []<class... N>(sph::TypeList<N...>) {
    return (std::is_same_v<typename N::Term, Term> || ...);
}(typename Composition::Nodes{});

template <class P, class Composition>
constexpr bool stores(auto field) {
    return sph::detail::contains<decltype(field), typename Composition::template FieldsOf<P>>;
}
/// Does any phase of the composition store the field?
template <class Composition>
constexpr bool anyone_stores(auto field) {
    return [field]<class... P>(sph::TypeList<P...>) {
        return (stores<P, Composition>(field) || ...);
    }(typename Composition::Phases{});
}

TEST_CASE("The costs of a scene are those of the evaluations that its integrator makes", "[effects]") {
    const auto with = []<class Integrator>(Integrator) {
        return sph::Costs<sph::Solver<3, float, Integrator, Viscous>>{};
    };
    using Euler = decltype(with(sph::SymplecticEuler{}));
    CHECK(Euler::sweeps<Viscous> == Costs<Viscous>::sweeps<Viscous>);
    CHECK(Euler::loads<Viscous, Viscous> == Costs<Viscous>::loads<Viscous, Viscous>);
    // Densities and forces each in a sweep of their own, as before, but in two passes: the equation of state is
    // in the second only.
    using Staggered = decltype(with(sph::StaggeredLeapfrog{}));
    CHECK(Staggered::sweeps<Viscous> == 2);
    CHECK(Staggered::loads<Viscous, Viscous> == Euler::loads<Viscous, Viscous>);
    // Rates and forces of one moment share a sweep.
    using Once = decltype(with(sph::PredictorCorrector{}));
    CHECK(Once::sweeps<Viscous> == 1);
    CHECK(Once::loads<Viscous, Viscous> < Euler::loads<Viscous, Viscous>);
    using Twice = decltype(with(sph::MidpointRungeKutta{}));
    CHECK(Twice::sweeps<Viscous> == 2);
    CHECK(Twice::loops == 2 * Once::loops);
    CHECK(Twice::numbers<Viscous> == Once::numbers<Viscous>);
}

TEST_CASE("A fluid without viscosity stores and computes nothing viscous", "[effects]") {
    using Without = Scene<Inviscid>;
    using With = Scene<Viscous>;
    static_assert(!computes<sph::MonaghanViscosity<K>, Without> && computes<sph::MonaghanViscosity<K>, With>);
    static_assert(Without::Nodes::size == With::Nodes::size - 1);
    // position, velocity, acceleration, mass; density and its rate, pressure, p/rho^2
    CHECK(Costs<Inviscid>::numbers<Inviscid> == 3 + 3 + 3 + 1 + 4);
    CHECK(Costs<Inviscid>::bytes<Inviscid, float> == 56);
    CHECK(Costs<Inviscid>::bytes<Inviscid, double> == 112);
    CHECK(Costs<Inviscid>::sweeps<Inviscid> == 2);
    CHECK(Costs<Inviscid>::rounds == 2);
    CHECK(Costs<Inviscid>::loops == 3);
    // Continuity loads place, mass and velocity; the pressure place, mass and p/rho^2.
    CHECK(Costs<Inviscid>::loads<Inviscid, Inviscid> == (3 + 1 + 3) + (3 + 1 + 1));
    // The viscosity needs no field that is not there, no sweep, but the neighbour's density and velocity.
    CHECK(Costs<Viscous>::numbers<Viscous> == Costs<Inviscid>::numbers<Inviscid>);
    CHECK(Costs<Viscous>::sweeps<Viscous> == 2);
    CHECK(Costs<Viscous>::loads<Viscous, Viscous> == Costs<Inviscid>::loads<Inviscid, Inviscid> + 1 + 3);
    // XSPH: a sum over velocities that has room in the sweep of the forces, and where it is kept.
    CHECK(Costs<Smoothed>::sweeps<Smoothed> == 2);
    CHECK(Costs<Smoothed>::loads<Smoothed, Smoothed> == Costs<Viscous>::loads<Viscous, Viscous>);
    CHECK(Costs<Smoothed>::numbers<Smoothed> > Costs<Viscous>::numbers<Viscous>);
}

TEST_CASE("A scene without a solid has no stress and no sweep for a coupling", "[effects]") {
    using Alone = Scene<Viscous>;
    using Dam = Scene<Viscous, Tank, Sides>;
    static_assert(!anyone_stores<Dam>(sph::deviatoric_stress) && !anyone_stores<Dam>(sph::velocity_gradient));
    static_assert(!anyone_stores<Dam>(sph::deformation_gradient) && !anyone_stores<Dam>(sph::reference_position));
    static_assert(!anyone_stores<Dam>(sph::mobility) && !anyone_stores<Dam>(sph::smoothed_velocity));
    static_assert(!stores<Tank, Dam>(sph::velocity) && !stores<Tank, Dam>(sph::acceleration));
    // What the water pays for itself is the same with and without the tank; the tank is swept once, for its pressure.
    CHECK(Costs<Viscous, Tank, Sides>::loads<Viscous, Viscous> == Costs<Viscous>::loads<Viscous, Viscous>);
    CHECK(Costs<Viscous, Tank, Sides>::numbers<Viscous> == Costs<Viscous>::numbers<Viscous>);
    CHECK(Costs<Viscous, Tank, Sides>::sweeps<Tank> == 1);
    CHECK(Costs<Viscous, Tank, Sides>::loads<Tank, Tank> == 0);
    CHECK(Costs<Viscous, Tank, Sides>::loads<Tank, Viscous> > 0);
    // Listed side by side without a coupling, two phases do not look at each other.
    CHECK(Costs<Viscous, Plate>::loads<Viscous, Plate> == 0);
    CHECK(Costs<Viscous, Plate>::loads<Plate, Viscous> == 0);
    CHECK(Costs<Viscous, Plate>::loads<Viscous, Viscous> == Costs<Viscous>::loads<Viscous, Viscous>);
    CHECK(Alone::plan.size == 3);
    // With it, each loads of the other its place, mass and density.
    CHECK(Costs<Viscous, Plate, Contact>::loads<Viscous, Plate> == 5);
    CHECK(Costs<Viscous, Plate, Contact>::loads<Plate, Viscous> == 5);
}

TEST_CASE("A solid pays for the stress it has", "[effects]") {
    using Hypoelastic = Scene<Rubber>;
    using Tense = Scene<Rings>;
    using Lagrangian = Scene<Plate>;
    static_assert(stores<Rubber, Hypoelastic>(sph::deviatoric_stress));
    static_assert(!stores<Rubber, Hypoelastic>(sph::reference_position) && !Hypoelastic::keeps_reference<Rubber>);
    static_assert(!stores<Plate, Lagrangian>(sph::deviatoric_stress) && !stores<Plate, Lagrangian>(sph::pressure));
    static_assert(Lagrangian::keeps_reference<Plate> && Lagrangian::OnceRows::size > 0);
    CHECK(Costs<Rubber>::sweeps<Rubber> == 2);
    CHECK(Costs<Plate>::sweeps<Plate> == 2);
    // The artificial stress: no sweep of its own, but six numbers to store and to load.
    CHECK(Costs<Rings>::sweeps<Rings> == 2);
    CHECK(Costs<Rings>::numbers<Rings> == Costs<Rubber>::numbers<Rubber> + 6);
    CHECK(Costs<Rings>::loads<Rings, Rings> == Costs<Rubber>::loads<Rubber, Rubber> + 6);
    CHECK(Tense::Nodes::size > Hypoelastic::Nodes::size);
}

TEST_CASE("A float particle of water takes at most 120 bytes, and 250 with its neighbours in packs of 16", "[effects]") {
    using Water = sph::Solver<3, float, sph::SymplecticEuler, Viscous>;
    const int m = 22;
    const double dx = 0.1;
    std::vector<Water::Point> points;
    for (int z = 0; z < m; ++z)
        for (int y = 0; y < m; ++y)
            for (int x = 0; x < m; ++x)
                points.push_back(dx * Water::Point(x + 0.01 * (y % 3), y + 0.01 * (z % 3), m - z + 0.01 * (x % 3)));
    Water scene({.support_radius = 2.6 * dx});
    scene.add(Viscous{{.density = 1000, .sound_speed = 30}}, points, dx);
    scene.step(1e-4); // everything is sorted once, so the room for sorting is there, too
    const double n = m * m * m, without = static_cast<double>(scene.engine().particle_bytes()) / n,
                 with = without + static_cast<double>(scene.engine().list_bytes()) / n;
    CAPTURE(without, with, Water::width);
    // Everything twice, for sorting, and an id; some room beyond the end.
    CHECK(without >= 2 * 56 + 4);
    CHECK(without <= 120);
    if (Water::width == 16) // a list is of packs: the narrower, the more there are of them
        CHECK(with <= 250);
    else if (Water::width == 8)
        CHECK(with <= 350);
}

TEST_CASE("Phases out of each other's reach have no neighbours to sweep, with periodic sides as well", "[effects]") {
    using Drip = sph::Solver<3, float, sph::SymplecticEuler, Viscous, Plate, Contact>;
    const bool periodic = GENERATE(false, true);
    const double dx = 0.1, H = 2.6 * dx;
    const auto make = [&](double gap) {
        std::vector<Drip::Point> points, above;
        for (int z = 0; z < 4; ++z)
            for (int y = 0; y < 10; ++y)
                for (int x = 0; x < 10; ++x)
                    points.push_back(dx * Drip::Point(x, y, z));
        for (const auto& x : points)
            above.push_back(x + Drip::Point(0, 0, 3 * dx + gap));
        Drip scene({.support_radius = H, .periodic_length = {periodic ? 1.0 : 0.0, 0, 0}, .threads = 1});
        scene.add(Plate{{.density = 1000, .sound_speed = 30, .shear_modulus = 1e5}}, points, dx);
        const auto water = scene.add(Viscous{{.density = 1000, .sound_speed = 30}}, above, dx);
        scene[water][sph::velocity].col(2).setConstant(-1);
        scene.prepare();
        return scene;
    };
    const auto swept = [](const Drip& scene) {
        return std::pair(!scene.engine().link<Plate, Viscous, false>().runs.is_empty(),
                         !scene.engine().link<Viscous, Plate, false>().runs.is_empty());
    };
    CHECK(swept(make(1.2 * H)) == std::pair(false, false));
    CHECK(swept(make(0.9 * H)) == std::pair(true, true));

    // It falls at 1 m/s through the gap of 1.2 supports; as soon as it is within reach, it pushes.
    Drip scene = make(1.2 * H);
    const auto speed = [&] { return scene.get<Plate>()[sph::velocity].norm(); };
    while (scene.time() < 0.15 * H)
        scene.step(0.01 * H);
    CHECK(swept(scene) == std::pair(false, false));
    CHECK(speed() == 0);
    while (scene.time() < 0.4 * H)
        scene.step(0.01 * H);
    CHECK(swept(scene) == std::pair(true, true));
    CHECK(speed() > 0);
}

TEST_CASE("Walls that no water is near have no neighbours to sweep", "[effects]") {
    const double dx = 0.1, H = 2.6 * dx;
    std::vector<sph::Point<3>> water, walls;
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 8; ++y)
            for (int z = 0; z < 3; ++z) {
                if (x < 4)
                    water.push_back(dx * sph::Point<3>(x, y, z));
                walls.push_back(dx * sph::Point<3>(x, y, z - 3));
            }
    sph::Solver<3, float, sph::SymplecticEuler, Viscous, Tank, Sides> scene({.support_radius = H, .threads = 1});
    scene.add(Viscous{{.density = 1000, .sound_speed = 30}}, water, dx);
    const auto tank = scene.add(Tank{{.density = 1000}}, walls, dx);
    scene.prepare();
    const auto& link = scene.engine().link<Tank, Viscous, false>();
    const auto pairs = scene.engine().pairs_of(link);
    const auto x = scene[tank][sph::position];
    int near = 0;
    for (int i = 0; i < scene[tank].size(); ++i) {
        const bool within = x(i, 0) < 3 * dx + 0.999 * H && x(i, 2) > -0.999 * H;
        CAPTURE(x(i, 0), x(i, 1), x(i, 2));
        if (x(i, 0) > 3 * dx + 1.001 * H)
            CHECK(pairs.is_alone(i));
        near += within && !pairs.is_alone(i);
    }
    CHECK(near > 50);
}

} // namespace effects_test
