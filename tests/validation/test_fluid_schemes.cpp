// The fluid schemes beside the first ones, in two dimensions: a decaying vortex against its exact solution, water at
// rest under its weight, and a dam break, with the Riemann scheme, its walls, and particle shifting.
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/riemann.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/staggered_leapfrog.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/riemann_wall.hpp>

#include <cases/validation/kolmogorov.hpp>
#include <cases/validation/laws_of_flow.hpp>
#include <cases/validation/taylor_green.hpp>
#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scheme_validation {

namespace sph = imbibe;
using K = sph::WendlandC2;
using Point = sph::Point<2>;
constexpr double support = 3; // H in spacings
constexpr int layers = 3;     // of a wall

// ---- Kolmogorov: slow flow under a pressure ----

TEST_CASE("CorrectedGradients flows as its viscosity says whatever pressure it is under", "[fluid]") {
    namespace slow = validation::kolmogorov;
    for (const double pressure : {0.0, 10.0, 100.0}) {
        const auto seen = slow::flow<slow::Corrected>({.pressure = pressure});
        CAPTURE(pressure, seen.viscosity, seen.off_density);
        CHECK(std::abs(seen.viscosity - 1) < (pressure < 100 ? 0.02 : 0.07));
        CHECK(seen.off_density < 2e-3);
    }
    // Without the correction its lattice resists.
    CHECK(slow::flow<slow::Plain>({.pressure = 100}).viscosity > 2);
}

// ---- liquids that thin, thicken or yield ----

TEST_CASE("Liquids that follow a law flow between plates as it says", "[fluid]") {
    for (const auto& row : validation::laws_of_flow::measure(12)) {
        CAPTURE(row.what, row.computed, row.reference);
        // A plug that is three particles wide is the hardest; docs/validation.md has the errors with 25.
        CHECK(std::abs(row.error()) < (row.what.find("yield stress") != std::string::npos ? 0.17 : 0.055));
    }
}

// ---- Taylor-Green: a square lattice of vortices, decaying ----

namespace square = validation::taylor_green;

/// Re = 100, 50 x 50 particles that start from a lattice jittered by `jitter` spacings.
template <class Liquid>
square::Decay vortices(double jitter, const Liquid& liquid = {}) {
    return square::decay({.across = 50, .jitter = jitter}, {0.5, 1}, liquid);
}
template <class Liquid>
square::Decay vortices_from_lattice() {
    Liquid liquid;
    liquid.set(square::strong_shifting);
    return vortices(0, liquid);
}

void check_vortices(const square::Decay& seen, double tolerance) {
    CAPTURE(seen.at[0].speed, seen.at[1].speed, seen.at[1].energy, seen.emptiest, seen.fullest);
    CHECK(std::abs(seen.at[0].speed - 1) < tolerance);
    CHECK(std::abs(seen.at[1].speed - 1) < tolerance);
    CHECK(seen.emptiest > 0.95); // no voids, no clumps
    CHECK(seen.fullest < 1.05);
}

TEST_CASE("Vortices decay as they should where particles are shifted", "[fluid]") {
    check_vortices(vortices<square::Shifted<K>>(0.05), 0.02);
    // The same without shifting loses a tenth of its speed: particles line up along the streamlines.
    const auto lined_up = vortices<square::Plain<K>>(0.05);
    CAPTURE(lined_up.at[0].speed, lined_up.at[1].speed, lined_up.at[1].energy);
    CHECK(lined_up.at[1].speed < 0.95);
}

// With the default coefficients a third of the speed is lost. At last 1.3 to 2.1 and 1.5 to 2.4 % too fast, as a
// lattice falls apart in one way or another: from 24 starts that differ by a millionth of a spacing. The bounds are
// their mean and three times their scatter.
TEST_CASE("Vortices decay as they should from a lattice, with strong shifting", "[fluid]") {
    check_vortices(vortices_from_lattice<square::Shifted<K>>(), 0.023);
    check_vortices(vortices_from_lattice<square::Antuono<K>>(), 0.027);
}

// The velocity that shifted particles take along is most of the error where viscosity does not wipe it out.
TEST_CASE("Vortices of little viscosity are right to half the error with TransportAdvection", "[fluid]") {
    const auto decayed = [](auto liquid) {
        liquid.set(square::strong_shifting);
        return square::decay({.across = 40, .reynolds = 1000, .neighbours = false}, {1}, liquid).at[0];
    };
    const auto carried = decayed(square::Shifted<K>{}), advected = decayed(square::Advected<K>{});
    CAPTURE(carried.error, advected.error, carried.speed, advected.speed);
    CHECK(advected.error < 0.6 * carried.error);
    CHECK(std::abs(advected.speed - 1) < 0.02);
}

// What steps of the default length add to the energy of vortices until t = 1, beside steps of a quarter: 3 % where
// densities stand half a step off the positions, 0.1 % where they do not.
TEST_CASE("Long steps add no energy to vortices with StaggeredLeapfrog", "[fluid]") {
    const auto energy = []<class Integrator>(Integrator, double cfl) {
        square::Shifted<K> liquid;
        liquid.set(square::strong_shifting);
        const square::Run run{.across = 25, .cfl = cfl, .reynolds = 1000, .neighbours = false};
        return square::decay<square::Shifted<K>, double, Integrator>(run, {1}, liquid).at[0].energy;
    };
    CHECK(std::abs(energy(sph::StaggeredLeapfrog{}, 0.4) - energy(sph::StaggeredLeapfrog{}, 0.1)) < 0.005);
    CHECK(energy(sph::SymplecticEuler{}, 0.4) - energy(sph::SymplecticEuler{}, 0.1) > 0.015);
}

// What its waves dissipate is seen in smooth flow: 3 to 4 % of the speed (the bound of 5 % was chosen after measuring).
TEST_CASE("Vortices decay a little fast with the Riemann scheme", "[fluid]") {
    const auto seen = vortices<square::Riemann<K>>(0.05);
    check_vortices(seen, 0.05);
    CHECK(seen.at[1].speed < 1);
}

// ---- water in a tank ----

struct Still : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>> {};
struct Water : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>, sph::DensityFloor> {};
struct Tank : sph::Wall<> {};
template <class W>
struct InTank : sph::Coupling<W, Tank, sph::Into<W, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                              sph::Into<W, sph::RiemannWallContinuity<K>>> {};

TEST_CASE("Water at rest between Riemann walls bears its weight", "[fluid]") {
    constexpr double g = 9.81, rho = 1000, spacing = 1.0 / 20, weight = rho * g;
    const double c = 10 * std::sqrt(2 * g), unit = std::sqrt(1 / g);
    const bool from_pressure = GENERATE(false, true);
    CAPTURE(from_pressure);
    sph::Solver<2, double, sph::SymplecticEuler, Still, Tank, InTank<Still>> scene(
        {.gravity = {0, -g}, .support_radius = support * spacing, .threads = 1});
    const auto water =
        scene.add(Still{{.density = rho, .sound_speed = c}}, sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, spacing), spacing);
    scene.add(Tank{{.density = rho}}, sph::tank(sph::Box<2>{{0, 0}, {1, 1.2}}, spacing, layers, sph::Sides::y_high),
              spacing);
    auto view = scene[water];
    if (from_pressure)
        for (int i = 0; i < view.size(); ++i)
            view[sph::density](i) += rho * g * (1 - view[sph::position](i, 1)) / (c * c);
    scene.run_until(10 * unit);
    // the mean over ten units of time, of each particle in the order it was added
    const auto number = static_cast<std::size_t>(view.size());
    std::vector<double> excess(number), height(number);
    double samples = 0, kinetic = 0;
    scene.run_until(20 * unit, [&](const auto& now) {
        const auto w = now.template get<Still>();
        for (int i = 0; i < w.size(); ++i) {
            const auto id = w.ids()[static_cast<std::size_t>(i)];
            height[id] += w[sph::position](i, 1);
            excess[id] += (w[sph::pressure](i) + rho * g * w[sph::position](i, 1)) / weight - 1;
        }
        kinetic = std::max(kinetic, sph::kinetic_energy(w));
        ++samples;
    });
    double bottom = 0, worst = 0;
    int lowest = 0;
    for (std::size_t id = 0; id < number; ++id) {
        worst = std::max(worst, std::abs(excess[id] / samples));
        if (height[id] / samples < spacing) {
            bottom += excess[id] / samples;
            ++lowest;
        }
    }
    CAPTURE(bottom / lowest, worst, kinetic);
    REQUIRE(lowest >= 18);
    CHECK(std::abs(bottom / lowest) < 0.01);
    CHECK(worst < 0.02);
    CHECK(kinetic < 0.2); // J; what a start without pressure sets free is weight/400, 25 J
}

// The lower bound on the energy was chosen after measuring.
TEST_CASE("A dam break between Riemann walls stays in its tank", "[fluid]") {
    constexpr double L = 0.146, H = 2 * L, g = 9.81, spacing = L / 24;
    const double fastest = 2 * std::sqrt(g * H); // of shallow water on a dry floor
    sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, InTank<Water>> scene(
        {.gravity = {0, -g}, .support_radius = support * spacing, .threads = 1});
    const auto water = scene.add(Water{{.density = 1000, .sound_speed = 10 * fastest}},
                                 sph::fill(sph::Box<2>{{0, 0}, {L, H}}, spacing), spacing);
    scene.add(Tank{{.density = 1000}},
              sph::tank(sph::Box<2>{{0, 0}, {4 * L, 3 * H}}, spacing, layers, sph::Sides::y_high), spacing);
    scene.coupling<InTank<Water>>().set(sph::RiemannWallPressureParameters{.suction = false});
    const auto energy = [&] {
        const auto view = scene[water];
        return sph::kinetic_energy(view) + sph::potential_energy(view, scene.settings().gravity) +
               sph::compression_energy(view);
    };
    const double at_start = energy();
    double before = at_start, front = L;
    for (int k = 1; k <= 12; ++k) {
        scene.run_until(0.25 * k * std::sqrt(H / g));
        const auto now = scene[water];
        const auto x = now[sph::position];
        const double lowest = x.col(1).minCoeff(), left = x.col(0).minCoeff(), right = x.col(0).maxCoeff();
        const double lightest = now[sph::density].minCoeff(), densest = now[sph::density].maxCoeff();
        CAPTURE(k, energy() / at_start, lowest / spacing, left / spacing, right / L, lightest, densest);
        CHECK(lowest > 0); // the wall's particles are half a spacing outside
        CHECK(left > 0);
        CHECK(right < 4 * L);
        CHECK(right - front < 0.25 * std::sqrt(H / g) * fastest);
        CHECK(energy() < 1.001 * before);
        CHECK(energy() > 0.9 * at_start);
        CHECK(lightest > 980);
        CHECK(densest < 1000 * 1.1); // an impact at `fastest` compresses by its share of the sound speed, a tenth
        before = energy();
        front = right;
    }
    CHECK(front > 3.9 * L);
}

// ---- water on a solid ----

struct Drop : sph::Fluid<sph::LinearState, sph::RiemannContinuity<K>, sph::RiemannPressure<K>, sph::DensityFloor> {};
struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::StVenantKirchhoff,
                          sph::TotalLagrangianForce<K>, sph::HourglassControl<K>> {};
struct Impact : sph::Coupling<Drop, Block, sph::Into<Drop, sph::RiemannWallNormal<K>>, sph::RiemannWallPressure<K>,
                              sph::Into<Drop, sph::RiemannWallContinuity<K>>> {};

TEST_CASE("A drop pushes a free block as hard as the block pushes it", "[fluid]") {
    constexpr double spacing = 1e-3;
    sph::Solver<2, double, sph::SymplecticEuler, Drop, Block, Impact> scene(
        {.support_radius = support * spacing, .threads = 1});
    const auto drop = scene.add(Drop{{.density = 1000, .sound_speed = 20}},
                                sph::fill(sph::Box<2>{{2e-3, 0}, {10e-3, 8e-3}}, spacing), spacing);
    const auto block = scene.add(Block{{.density = 1200, .sound_speed = 30, .shear_modulus = 2e5}},
                                 sph::fill(sph::Box<2>{{0, -6e-3}, {12e-3, 0}}, spacing), spacing);
    auto view = scene[drop];
    for (int i = 0; i < view.size(); ++i)
        view[sph::velocity](i, 1) = -1;
    const double given = sph::momentum(scene[drop])[1];
    scene.run_until(4e-3);
    const auto total = (sph::momentum(scene[drop]) + sph::momentum(scene[block])).eval();
    const double energy = sph::kinetic_energy(scene[drop]) + sph::compression_energy(scene[drop]) +
                          sph::kinetic_energy(scene[block]) + sph::elastic_energy<2>(scene[block]);
    const auto x = scene[drop][sph::position];
    int inside = 0; // in the middle of the block, where it was or has been pushed to
    for (int i = 0; i < x.rows(); ++i)
        inside += scene[block][sph::position].col(1).maxCoeff() - spacing > x(i, 1) && x(i, 0) > 0 && x(i, 0) < 12e-3;
    CAPTURE(total[0] / given, total[1] / given, sph::momentum(scene[block])[1] / given, energy, inside);
    CHECK(std::abs(total[0]) < 1e-12 * std::abs(given));
    CHECK(std::abs(total[1] - given) < 1e-12 * std::abs(given));
    CHECK(sph::momentum(scene[block])[1] / given > 0.3);
    CHECK(energy < 0.5 * std::abs(given)); // J/m: the drop's at the start, with 1 m/s
    CHECK(inside == 0);
}

} // namespace scheme_validation
