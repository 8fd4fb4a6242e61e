// CorrectedVelocityGradient and CorrectedStressForce: exact gradients, in disorder and at free surfaces; equal and
// opposite forces, no torque, and as much work as strain counts; simple shear in closed form; the period and the energy
// of a bar.
#include "corrected_rate.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/longest_stable_step.hpp>
#include <imbibe/solid/corrected_gradients.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/stress_force.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/leapfrog.hpp>
#include <imbibe/time/midpoint_runge_kutta.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <cmath>

namespace corrected_solid_test {

using namespace cloud;

namespace {

using K = WendlandC2;

Sponge rubber_here() {
    return {.density = 1000, .sound_speed = 30, .shear_modulus = 2e5, .support_radius = 2.6e-3, .spacing = 1e-3};
}

/// A block with its corrections and volumes; velocities as a function of the place.
template <int dim, class Velocity>
Cloud<dim, Sponge> corrected_block(int n, double jitter, Velocity v) {
    auto solid = block<dim>(rubber_here(), n, jitter);
    for (auto& a : solid)
        a.set(volume, a[mass] / a[density]).set(velocity, vec<dim>(v(ColumnVector<dim>(plain(a[position])))));
    gather(CorrectionNeighbours<K>::Sum{}, moment_matrix, solid, solid);
    prepare(CurrentCorrection<K>::Invert{}, gradient_correction, solid);
    return solid;
}

template <int dim>
void check_gradient() {
    Matrix<dim> exact = Matrix<dim>::Constant(0.7);
    exact(0, 0) = -2;
    exact(1, 0) = 3;
    const auto solid = corrected_block<dim>(dim == 2 ? 7 : 5, 0.2, [&](const ColumnVector<dim>& x) {
        return ColumnVector<dim>(exact * x + ColumnVector<dim>::Constant(5));
    });
    double worst = 0, uncorrected = 0;
    for (const auto& a : solid) {
        const auto error = [&](const auto& part) { return (plain(sum(part, a, solid)) - exact).norm() / exact.norm(); };
        worst = std::max(worst, error(CorrectedVelocityGradient<K>{}));
        uncorrected = std::max(uncorrected, error(VelocityGradient<K>{}));
    }
    CHECK(worst < 1e-12);
    CHECK(uncorrected > 0.3);
    auto smooth = solid;
    for (auto& a : smooth)
        a.set(smoothed_velocity, a[velocity]).set(velocity, Vector<Number<double>, dim>::filled(0.7));
    CHECK((plain(sum(CorrectedVelocityGradient<K, smoothed_velocity>{}, smooth[0], smooth)) - exact).norm() < 1e-11);
    CHECK(plain(sum(CorrectedVelocityGradient<K>{}, smooth[0], smooth)).norm() == 0); // of a uniform velocity
}

// sum_a m_a a_a = 0, sum_a m_a x_a x a_a = 0, and sum_a m_a v_a.a_a = - sum_a V_a sigma_a : dv_a/dx.
template <int dim>
void check_force() {
    using Force = CorrectedStressForce<K>;
    Dice dice(3);
    auto solid = corrected_block<dim>(dim == 2 ? 6 : 4, 0.2,
                                      [&](const ColumnVector<dim>&) { return plain(dice.vector<dim>(2)); });
    for (auto& a : solid) {
        SymmetricTensor<Number<double>, dim> S{};
        for (auto& c : S.c)
            c = dice(-1000, 1000);
        a.set(deviatoric_stress, S).set(pressure, dice(500, 1500));
    }
    prepare(Force::Prepare{}, corrected_stress, solid);
    ColumnVector<dim> force = ColumnVector<dim>::Zero();
    double torque = 0, work = 0, strain = 0, size = 0, arm = 0;
    for (const auto& a : solid) {
        const ColumnVector<dim> x = plain(a[position]);
        const ColumnVector<dim> f = plain(a[mass]) * plain(sum(Force::Push{}, a, solid));
        const Matrix<dim> sigma = plain(a[deviatoric_stress]) - plain(a[pressure]) * Matrix<dim>::Identity();
        force += f;
        torque += x[0] * f[1] - x[1] * f[0];
        size += f.norm();
        arm += x.norm() * f.norm();
        work += f.dot(plain(a[velocity]));
        strain += plain(a[volume]) * sigma.cwiseProduct(plain(sum(CorrectedVelocityGradient<K>{}, a, solid))).sum();
        CHECK(corrected_rate<K>(a, solid) ==
              Approx(-1000 * plain(sum(CorrectedVelocityGradient<K>{}, a, solid)).trace()).epsilon(1e-9));
    }
    CHECK(worst_imbalance(Force::Push{}, solid, solid) == 0); // equal masses: to the last bit
    CHECK(force.norm() < 1e-13 * size);
    CHECK(std::abs(torque) < 1e-13 * arm);
    CHECK(work == Approx(-strain).epsilon(1e-11));
    CHECK(std::abs(work) > 1e-3 * size);
    // by hand, one pair
    const auto &a = solid[0], &b = solid[1];
    const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
    const double r = x.norm(), q = r / 2.6e-3;
    const double slope = -20 * (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(2.6e-3, dim + 1) * q * std::pow(1 - q, 3);
    const auto stress = [](const auto& p) {
        return Matrix<dim>((plain(p[deviatoric_stress]) - plain(p[pressure]) * Matrix<dim>::Identity()) *
                           plain(p[gradient_correction]));
    };
    const ColumnVector<dim> expected =
        plain(a[volume]) * plain(b[volume]) / plain(a[mass]) * ((stress(a) + stress(b)) * (slope / r * x));
    const ColumnVector<dim> found = plain(Force::Push{}(a, b, geometry<Force::Push, dim>(a, b)));
    CHECK((found - expected).norm() < 1e-10 * expected.norm());
}

// ---- simple shear ----

struct Sheared : imbibe::Solid<VelocityGradient<K>, JaumannStress> {};
struct CorrectlySheared : imbibe::Solid<CurrentCorrection<K>, CorrectedVelocityGradient<K>, JaumannStress> {};

/// How far S_xy is from G sin(shear), as a share of G: at the worst particle inside, at the worst of all, and at how
/// many by more than 1e-4.
struct ShearError {
    double inside = 0, anywhere = 0;
    int many = 0;
};
/// Particles on straight lines, each with the constant velocity (y, 0): what they are in is simple shear, exactly.
template <class Phase>
std::vector<ShearError> shear_errors(const std::vector<double>& shears) {
    const double dx = 0.1;
    const int columns = 32, rows = 8;
    Solver<2, double, MidpointRungeKutta, Phase> scene({.support_radius = 2.6 * dx, .threads = 1});
    const auto solid = scene.add(Phase{{.density = 1000, .sound_speed = 1, .shear_modulus = 3}},
                                 fill(Box<2>({0, 0}, {columns * dx, rows * dx}), dx), dx);
    for (int i = 0; i < columns * rows; ++i)
        scene[solid][velocity](i, 0) = scene[solid][position](i, 1);
    std::vector<ShearError> errors;
    for (const double shear : shears) {
        while (scene.time() < shear - 1e-9)
            scene.step(0.005);
        ShearError found;
        const auto view = scene[solid];
        for (int i = 0; i < view.size(); ++i) {
            const int id = static_cast<int>(view.ids()[static_cast<std::size_t>(i)]);
            const int column = id % columns, row = id / columns;
            const double error = view[deviatoric_stress](i, 1) / 3 - std::sin(scene.time());
            if (std::min(column, columns - 1 - column) >= 12 && std::min(row, rows - 1 - row) >= 3 &&
                std::abs(error) > std::abs(found.inside))
                found.inside = error;
            found.anywhere = std::max(found.anywhere, std::abs(error));
            found.many += std::abs(error) > 1e-4;
        }
        errors.push_back(found);
    }
    return errors;
}

// ---- a bar that swings along itself ----

template <class... Terms>
struct Elastic : imbibe::Solid<LinearState, Terms..., JaumannStress> {};
using PlainBar = Elastic<Continuity<K>, VelocityGradient<K>, StressForce<K>>;
using CorrectedBar =
    Elastic<CurrentCorrection<K>, CorrectedContinuity<K>, CorrectedVelocityGradient<K>, CorrectedStressForce<K>>;
using MixedBar = Elastic<CurrentCorrection<K>, Continuity<K>, CorrectedVelocityGradient<K>, StressForce<K>>;

struct Swing {
    double period = 0;              // over that of a thin bar in plane strain, 2 L sqrt(rho (1 - nu^2)/E)
    double least = 1e300, most = 0; // energy over that at the start, at the end of each of ten periods
};
template <class Phase>
Swing swing(double cfl) {
    const double dx = 0.05, length = 2, young = 1e5, poisson = 0.3, rho = 1000;
    Solver<2, double, Leapfrog, Phase> scene({.support_radius = 2.6 * dx, .cfl = cfl, .threads = 1});
    const auto bar = scene.add(Phase{{.density = rho,
                                      .sound_speed = sound_speed_of(young, poisson, rho),
                                      .shear_modulus = shear_modulus_of(young, poisson)}},
                               fill(Box<2>({0, 0}, {length, 0.5}), dx), dx);
    const auto left = [&](double x) { return x < length / 2; };
    for (int i = 0; i < scene[bar].size(); ++i)
        scene[bar][velocity](i, 0) = 0.01 * std::cos(pi * scene[bar][position](i, 0) / length);
    const auto energy = [&] {
        return kinetic_energy(scene[bar]) + compression_energy(scene[bar]) + shear_energy<2>(scene[bar]);
    };
    const double at_start = energy(), theory = 2 * length * std::sqrt(rho * (1 - poisson * poisson) / young);
    Swing seen;
    double first = 0, last = 0, before = 1;
    int turns = 0;
    for (int k = 1; k <= 10; ++k) {
        scene.run_until(k * theory, [&](const auto& s) {
            const auto view = s[bar];
            double apart = 0;
            for (int i = 0; i < view.size(); ++i)
                apart += view[velocity](i, 0) * (left(view[position](i, 0)) ? 1 : -1);
            if (apart * before < 0) {
                last = s.time();
                first = turns++ == 0 ? last : first;
            }
            before = apart;
        });
        seen.least = std::min(seen.least, energy() / at_start);
        seen.most = std::max(seen.most, energy() / at_start);
    }
    seen.period = 2 * (last - first) / (turns - 1) / theory;
    return seen;
}

/// The longest step that a block bears, over the limit.
template <int dim>
double borne(double support, double jitter, double poisson) {
    const double dx = 0.05, young = 1e5, rho = 1000;
    Solver<dim, double, SymplecticEuler, CorrectedBar> scene({.support_radius = support * dx, .threads = 1});
    Dice dice(2);
    auto points = fill(Box<dim>(Point<dim>::Zero(), Point<dim>::Constant((dim == 2 ? 10 : 5) * dx)), dx);
    for (auto& x : points)
        for (int d = 0; d < dim; ++d)
            x[d] += jitter * dx * dice(-1, 1);
    scene.add(CorrectedBar{{.density = rho,
                            .sound_speed = sound_speed_of(young, poisson, rho),
                            .shear_modulus = shear_modulus_of(young, poisson)}},
              points, dx);
    scene.step(1e-9); // then the corrections are known
    const auto limit = scene.time_step_limits().front();
    CHECK(limit.reason == "corrected gradients");
    return longest_stable_step(scene) / limit.seconds;
}

} // namespace

TEST_CASE("CorrectedVelocityGradient is exact for linear velocities, at a surface too") {
    check_gradient<2>();
    check_gradient<3>();
}

TEST_CASE("CorrectedStressForce conserves momentum, angular momentum and energy") {
    check_force<2>();
    check_force<3>();
}

TEST_CASE("simple shear of a block: S_xy is G sin(shear), with corrected gradients also at the surface") {
    const auto plain = shear_errors<Sheared>({0.5, 1, pi}), corrected = shear_errors<CorrectlySheared>({0.5, 1, pi});
    CHECK(plain[1].inside == Approx(-0.0145).margin(5e-4));
    CHECK(plain[2].inside == Approx(0.081).margin(2e-3));
    CHECK(plain[1].anywhere == Approx(0.63).margin(0.01));
    CHECK(plain[2].anywhere == Approx(1.05).margin(0.01));
    CHECK(corrected[0].anywhere < 2e-5);
    for (const auto& at : corrected)
        CHECK(std::abs(at.inside) < 2e-5);
    // what the acute corners lose, which are drawn out to threads
    CHECK(corrected[1].many <= 2);
    CHECK(corrected[2].many <= 16);
}

TEST_CASE("a bar with corrected gradients swings with the period of theory and keeps its energy") {
    const Swing plain = swing<PlainBar>(0.4), corrected = swing<CorrectedBar>(0.4);
    CAPTURE(plain.period, corrected.period, corrected.least, corrected.most);
    CHECK(plain.period == Approx(1.076).margin(0.002));
    CHECK(corrected.period == Approx(1.006).margin(0.002));
    CHECK(corrected.least > 0.999);
    CHECK(corrected.most < 1.001);
    // a force that is not the counterpart of the gradient: not a matter of the step
    for (const double cfl : {0.4, 0.2}) {
        const Swing mixed = swing<MixedBar>(cfl);
        CAPTURE(mixed.most);
        CHECK(mixed.most == Approx(1.067).margin(0.005));
    }
}

TEST_CASE("the limit on steps of CorrectedStressForce holds, and is not timid") {
    TimeStepInput in{.support_radius = 2.6e-3, .spacing = 1e-3, .max_speed = 1, .max_acceleration = 0, .dimension = 2};
    const double sound = acoustic_time_step(rubber_here(), in);
    CHECK(CorrectedStressForce<K>::time_step_limit(rubber_here(), in) == sound);
    in.greatest = 6;
    CHECK(CorrectedStressForce<K>::time_step_limit(rubber_here(), in) == Approx(sound / 2)); // 1 + 1.4 * 5 = 8
    for (const double poisson : {0.0, 0.3, 0.45})
        for (const double support : {2.0, 2.6, 3.0})
            for (const double jitter : {0.0, 0.3}) {
                const double plane = borne<2>(support, jitter, poisson);
                CAPTURE(poisson, support, jitter);
                CHECK(plane > 1.1);
                CHECK(plane < 1.9);
                if (support < 3) {
                    const double space = borne<3>(support, jitter, poisson);
                    CHECK(space > 1.05);
                    CHECK(space < 1.9);
                }
            }
}

} // namespace corrected_solid_test
