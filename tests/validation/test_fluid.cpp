// Fluids in two dimensions against numbers from outside: water at rest in a tank (its weight), the start-up of a flow
// between plates (the series solution) and the front of a dam break (Koshizuka and Oka 1996).
#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/density_diffusion.hpp>
#include <imbibe/fluid/density_floor.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/volume_pressure.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>
#include <imbibe/wall/pressure_extrapolation.hpp>

#include <cases/validation/plates.hpp>
#include <cases/validation/still_water.hpp>
#include <catch_shim.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace fluid_validation {

namespace sph = imbibe;
namespace plates = validation::plates;
namespace still_water = validation::still_water;
using K = sph::WendlandC2;
using Point = sph::Point<2>;

// H in spacings. On a square lattice the sum - sum_b V y_b dW/dy, which is 1 for the continuum and scales every
// gradient of pressure and every viscosity, is 0.9974 with 3 spacings of WendlandC2, and 0.9739 with 2.6.
constexpr double support = 3, lattice_error = 1 - 0.9974;
constexpr int layers = 3; // of a wall

// ---- water in a tank whose walls do not stick ----

TEST_CASE("Water at rest bears its weight and comes to rest", "[fluid]") {
    const bool hydrostatic = GENERATE(false, true);
    CAPTURE(hydrostatic);
    still_water::Column<> column(20, hydrostatic);
    // The greatest kinetic energy in each fifth of t sqrt(g/H) = 50. Started without pressure, the column falls into
    // its own compression, g H/c^2 H/2 = H/400 deep on average: 1/400 of rho g H^3 is set free at the most.
    std::array<double, 5> kinetic{};
    for (std::size_t k = 0; k < kinetic.size(); ++k)
        kinetic[k] = column.greatest_kinetic_until(10.0 * static_cast<double>(k + 1));
    // The column goes on breathing for a while: 1e-2 J of it are 3 % of the pressure at the bottom, up and down. So the
    // pressure is that of the mean over 18 periods, of 4 H/c each.
    const auto off = column.deviation_until(55);
    REQUIRE(off.row >= 18); // a row of the lattice has 20
    CAPTURE(kinetic[0], kinetic[1], kinetic[2], kinetic[3], kinetic[4], off.bottom, off.worst);
    CHECK(std::abs(off.bottom) < 0.005);
    CHECK(off.worst < 0.01);
    CHECK(kinetic[0] < still_water::weight / 400);
    // Chosen after first runs: the energy does not fall in each fifth, because particles go on finding better places,
    // one by one. So each fifth is held against that of a start without pressure (9 J): a half of it, where the column
    // starts with its pressure 1/400, and a thousandth in the last.
    const double released = 9;
    for (const double later : {kinetic[1], kinetic[2], kinetic[3]})
        CHECK(later < released * (hydrostatic ? 1.0 / 400 : 0.5));
    CHECK(kinetic[4] < 1e-3 * released);
}

// The bounds were set before the run: 5 % of the weight, and a surface within half a spacing of where it was.
TEST_CASE("With SummationFloor water at rest bears its weight, and its surface stays where it is", "[fluid]") {
    const bool hydrostatic = GENERATE(false, true);
    CAPTURE(hydrostatic);
    constexpr int across = 20;
    still_water::Column<still_water::Floored, still_water::FlooredInTank> column(across, hydrostatic);
    const double half_spacing = still_water::side / across / 2;
    column.greatest_kinetic_until(40);
    const double kinetic = column.greatest_kinetic_until(50);
    const auto off = column.deviation_until(55);
    REQUIRE(off.row >= 18); // a row of the lattice has 20
    CAPTURE(kinetic, off.bottom, off.worst, column.top(), column.mean_level());
    CHECK(std::abs(off.bottom) < 0.05);
    CHECK(off.worst < 0.05);
    CHECK(std::abs(column.top() - still_water::side) < half_spacing);
    CHECK(std::abs(column.mean_level() - still_water::side) < half_spacing);
    CHECK(kinetic < 1e-3 * 9); // at rest: a thousandth of what a start without pressure sets free, as above
}

// ---- flow between plates ----

/// Relative errors of the velocity at the centre at `plates::times`, with this many particles across.
template <class Liquid = plates::Oil<K>>
std::array<double, 5> poiseuille(int across, double support_in_spacings = support) {
    auto errors = plates::middle_velocities<K, Liquid>(plates::poiseuille, across, support_in_spacings);
    for (std::size_t k = 0; k < errors.size(); ++k)
        errors[k] = errors[k] / plates::poiseuille.middle[k] - 1;
    return errors;
}

TEST_CASE("Flow between plates starts up as the series says", "[fluid]") {
    const auto coarse = poiseuille(10), middle = poiseuille(20), fine = poiseuille(40);
    for (std::size_t k = 0; k < plates::times.size(); ++k) {
        CAPTURE(plates::times[k], coarse[k], middle[k], fine[k]);
        CHECK(std::abs(fine[k]) < 0.007);
    }
    // Finer spacing with the same H in spacings does not converge to zero but to the error of the lattice sum: a flow
    // that is faster by 0.26 % in the end. To that it converges, with the order 1.5 asked for.
    const double order = std::log2((coarse[4] - middle[4]) / (middle[4] - fine[4]));
    const double limit = fine[4] - (middle[4] - fine[4]) / (std::exp2(order) - 1);
    CAPTURE(coarse[4], middle[4], fine[4], order, limit);
    CHECK(order > 1.5);
    CHECK(std::abs(limit - lattice_error) < 0.001); // chosen after seeing the errors
}

TEST_CASE("With corrected gradients a flow between plates converges, with few neighbours too", "[fluid]") {
    using Liquid = plates::CorrectedOil<K>;
    const auto coarse = poiseuille<Liquid>(10, 2), middle = poiseuille<Liquid>(20, 2), fine = poiseuille<Liquid>(40, 2);
    for (std::size_t k = 0; k < plates::times.size(); ++k) {
        CAPTURE(plates::times[k], coarse[k], middle[k], fine[k]);
        CHECK(std::abs(fine[k]) < 0.002);
        if (k == 0) // the middle has hardly felt the plates yet
            continue;
        CHECK(std::log2(coarse[k] / middle[k]) > 1.5);
        CHECK(std::log2(middle[k] / fine[k]) > 1.5);
    }
    CHECK(std::abs(poiseuille(40, 2)[4]) > 0.01); // without: the error of the lattice sum
}

TEST_CASE("Flow under a moving plate starts up as the series says", "[fluid]") {
    // With 4 spacings of support: the lattice sum is then 0.9992, and the order is that of the walls and the kernel.
    const auto errors = [](int across) { // of the plate's speed
        auto found = plates::middle_velocities<K>(plates::couette, across, 4);
        for (std::size_t k = 0; k < found.size(); ++k)
            found[k] = (found[k] - plates::couette.middle[k]) / plates::couette.lid;
        return found;
    };
    const auto coarse = errors(10), fine = errors(20);
    for (std::size_t k = 0; k < plates::times.size(); ++k) {
        CAPTURE(plates::times[k], coarse[k], fine[k]);
        CHECK(std::abs(fine[k]) < 0.007);
    }
    CHECK(std::log2(coarse[2] / fine[2]) > 1.5); // the order of convergence, at 0.1125 s
}

// ---- dam break ----

struct Water : sph::Fluid<sph::LinearState, sph::VolumeContinuity<K>, sph::DensityDiffusion<K>, sph::DensityFloor,
                          sph::VolumePressure<K>, sph::MonaghanViscosity<K>> {};
struct Tank : sph::Wall<> {};
struct WaterInTank : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<K>>, sph::VolumePressure<K>,
                                   sph::Into<Water, sph::VolumeContinuity<K>>> {};
using DamScene = sph::Solver<2, double, sph::SymplecticEuler, Water, Tank, WaterInTank>;

// The water of the experiment starts late (a gate is pulled up) and rubs on the floor, which may be why this front is 5
// to 10 % ahead until T = 1.6 and then up to 21 %, more than the 5 to 10 % that is usual. Without DensityFloor and with
// suction it is the same, at L/16 up to three per cent less, at L/64 (to T = 1.9 only) one or two more. The band of
// 25 %, that the front is ahead at all, and the bound on the energy were chosen after that was measured; the limit on
// the speed was not.
TEST_CASE("The front of a dam break is ahead of the experiment, and not too fast", "[fluid]") {
    constexpr double L = 0.146, H = 2 * L, g = 9.81, spacing = L / 32;
    // T = t sqrt(2 g/L) and Z = x/L, as read from the experiment.
    constexpr std::array<std::array<double, 2>, 7> measured{{{.769, 1.252},
                                                             {1.153, 1.505},
                                                             {1.537, 1.892},
                                                             {1.935, 2.241},
                                                             {2.323, 2.615},
                                                             {2.719, 3.003},
                                                             {3.096, 3.624}}};
    const double fastest = 2 * std::sqrt(g * H); // of shallow water on a dry floor
    DamScene scene({.gravity = {0, -g}, .support_radius = support * spacing, .threads = 1});
    Water water{{.density = 1000, .sound_speed = 10 * fastest}};
    water.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    const auto handle = scene.add(water, sph::fill(sph::Box<2>{{0, 0}, {L, H}}, spacing), spacing);
    scene.add(Tank{{.density = 1000}},
              sph::tank(sph::Box<2>{{0, 0}, {4 * L, 1.2 * H}}, spacing, layers, sph::Sides::y_high), spacing);
    scene.coupling<WaterInTank>().set(sph::PressureExtrapolationParameters{.suction = false});
    const auto energy = [&] {
        const auto view = scene[handle];
        return sph::kinetic_energy(view) + sph::potential_energy(view, scene.settings().gravity) +
               sph::compression_energy(view);
    };
    const auto front = [&] { return scene[handle][sph::position].col(0).maxCoeff() + spacing / 2; };
    const double energy_at_start = energy();
    double before = L, time_before = 0;
    for (const auto& [T, Z] : measured) {
        scene.run_until(T * std::sqrt(L / (2 * g)));
        const double now = front(), speed = (now - before) / (scene.time() - time_before);
        CAPTURE(T, Z, now / L, now / L / Z, speed / fastest, energy() / energy_at_start);
        CHECK(speed < fastest);
        // No energy out of nothing, and little is lost before the front is at the far wall (5 %: chosen after
        // measuring 3 % at L/32 and 4.6 % at L/16).
        CHECK(energy() < 1.001 * energy_at_start);
        CHECK(energy() > 0.95 * energy_at_start);
        CHECK(now / L > Z);
        CHECK(now / L < 1.25 * Z);
        before = now;
        time_before = scene.time();
    }
    CHECK(before < 4 * L + spacing); // the wall holds it
}

} // namespace fluid_validation
