// The coupling of the paper, Eqs. (23) to (25): value and sign of the repulsion, its time step, action and reaction.
#include "hand.hpp"

#include <imbibe/coupling/kernel_repulsion.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <eigenvalues.hpp>

namespace coupling_test {

using namespace hand;

namespace {

template <int dim>
using LaplacianKernel = std::conditional_t<dim == 3, ViscosityKernel, ViscosityKernel2D>;

template <int dim>
void check_pairwise_balance() {
    Dice dice(100 + dim);
    using Push = typename SymmetricPressure<Spiky>::Push;
    const LaminarViscosity<LaplacianKernel<dim>> viscosity;
    const KernelRepulsion<> repulsion;
    for (int k = 0; k < 200; ++k) {
        auto f = dice.particle<dim>(water(), dice.vector<dim>(0.28 * H));
        auto s = dice.particle<dim>(sponge(), dice.vector<dim>(0.28 * H));
        f.set(pressure_over_density2, typename SymmetricPressure<Spiky>::Prepare{}(f));
        s.set(pressure_over_density2, typename SymmetricPressure<Spiky>::Prepare{}(s));
        const auto fs = pair_of(f, s), sf = pair_of(s, f);
        const double mf = plain(f[mass]), ms = plain(s[mass]), rf = plain(f[density]), rs = plain(s[density]);
        const double Vf = mf / rf, Vs = ms / rs;
        const ColumnVector<dim> x = plain(fs.offset);

        const ColumnVector<dim> pressure_force =
            -mf * ms * (plain(f[pressure]) / (rf * rf) + plain(s[pressure]) / (rs * rs)) * spiky_gradient<dim>(x);
        const ColumnVector<dim> viscous_force =
            3.5e-3 * Vf * Vs * (plain(s[velocity]) - plain(f[velocity])) * viscosity_laplacian<dim>(x.norm());
        const ColumnVector<dim> repulsive_force = -1e8 * Vf * Vs * spiky_gradient<dim>(x);

        const auto check = [&](const auto& term, const ColumnVector<dim>& force) {
            const ColumnVector<dim> on_f = mf * plain(contribution(fs, term(f, s, fs)));
            const ColumnVector<dim> on_s = ms * plain(contribution(sf, term(s, f, sf)));
            REQUIRE(relative_error(on_f, force) < 1e-11);
            REQUIRE((on_f + on_s).norm() < 1e-15 * force.norm()); // a few roundings each
        };
        check(Push{}, pressure_force);
        check(viscosity, viscous_force);
        check(repulsion, repulsive_force);
    }
}

template <int dim>
double repulsion_limit_by_notes(double mass_f, double speed, double stiffness, double Vf, double Vs, double mass_s) {
    // 3D: delta = H (pi H^3 m v^2/(30 K V V))^(1/3), k = 90 K V V delta/(pi H^6); 15/pi is 10/pi in 2D
    const double norm = dim == 3 ? 15 / pi : 10 / pi;
    const double delta =
        std::min(H, H * std::cbrt(std::pow(H, dim) * mass_f * speed * speed / (2 * norm * stiffness * Vf * Vs)));
    const double k = 6 * norm * stiffness * Vf * Vs * delta / std::pow(H, dim + 3);
    return 2 * std::sqrt(mass_f * mass_s / (mass_f + mass_s) / k);
}

} // namespace

TEST_CASE("KernelRepulsion is the mended Eq. (24): 4.5e7 m/s^2 a neighbour, and it repels") {
    Particle<3, Number<double>, Water> f(water());
    Particle<3, Number<double>, Sponge> s(sponge());
    f.set(position, {0, 0, 0}).set(mass, 1000 * std::pow(8e-4, 3)).set(density, 1000);
    s.set(position, {0.5 * H, 0, 0}).set(mass, 950 * std::pow(5e-4, 3)).set(density, 950);
    const KernelRepulsion<> term;
    const auto ab = pair_of(f, s);
    const ColumnVector<3> push = plain(contribution(ab, term(f, s, ab)));
    CHECK(push[0] == Approx(-4.5e7).epsilon(0.01));
    CHECK(push[1] == 0);
    CHECK(plain(contribution(pair_of(s, f), term(s, f, pair_of(s, f))))[0] > 0);
}

TEST_CASE("KernelRepulsion with a range of its own reaches as far, and no further") {
    auto f = water();
    auto s = sponge();
    f.spacing = 0.8e-3;
    s.spacing = 0.5e-3;
    const double reach = 0.7 * 0.65e-3, K = 1e4;
    KernelRepulsion<> term;
    term.parameters = {.stiffness = K, .range = 0.7};
    const auto push = [&](double distance) {
        Particle<3, Number<double>, Water> a(f);
        Particle<3, Number<double>, Sponge> b(s);
        a.set(position, {0, 0, 0}).set(mass, 1000 * std::pow(8e-4, 3)).set(density, 1000);
        b.set(position, {distance, 0, 0}).set(mass, 950 * std::pow(5e-4, 3)).set(density, 950);
        const auto ab = pair_of(a, b);
        return plain(contribution(ab, term(a, b, ab)))[0];
    };
    CHECK(push(1.0001 * reach) == 0);
    const double at = 0.5 * reach; // dW/dr = -45/(pi R^6) (R - r)^2
    const double slope = 45 / (pi * std::pow(reach, 6)) * (reach - at) * (reach - at);
    CHECK(push(at) == Approx(-K * std::pow(5e-4, 3) / 1000 * slope).epsilon(1e-9));
    // The limit on the step is that of the shorter kernel.
    const TimeStepInput in{H, 8e-4, 0.3, 0, 3, 5e-4, 0.0};
    TimeStepInput shorter = in;
    shorter.support_radius = reach;
    CHECK(KernelRepulsion<>::time_step_limit(f, s, in, term.parameters) ==
          Approx(KernelRepulsion<>::time_step_limit(f, s, shorter, {.stiffness = K})).epsilon(1e-12));
    // A range beyond the support radius is one of the support radius, in the force and in the limits.
    const double held = push(0.5 * H);
    CHECK(held == 0);
    term.parameters.range = 5;
    const double of_the_support = 45 / (pi * std::pow(H, 6)) * sq(0.5 * H);
    CHECK(push(0.5 * H) == Approx(-K * std::pow(5e-4, 3) / 1000 * of_the_support).epsilon(1e-9));
    CHECK(KernelRepulsion<>::time_step_limit(f, s, in, {.stiffness = K, .range = 5}) ==
          KernelRepulsion<>::time_step_limit(f, s, in, {.stiffness = K}));
    CHECK(KernelRepulsion<>::time_step_limit(f, in, {.stiffness = K, .range = 5}) ==
          KernelRepulsion<>::time_step_limit(f, in, {.stiffness = K}));
}

TEST_CASE("the terms of the fluid in a coupling are Eqs. (23) and (25), pair by pair") {
    check_pairwise_balance<2>();
    check_pairwise_balance<3>();
}

TEST_CASE("the limit of the repulsion is that of the notes for Spiky") {
    const double Vf = std::pow(8e-4, 3), Vs = std::pow(5e-4, 3);
    for (const double K : {1e6, 1e8, 1e9})
        for (const double speed : {0.01, 0.3, 1.0}) {
            const TimeStepInput in{H, 8e-4, speed, 0, 3, 5e-4, 0.0};
            const double limit = KernelRepulsion<>::time_step_limit(water(), sponge(), in, {.stiffness = K});
            CHECK(limit == Approx(repulsion_limit_by_notes<3>(1000 * Vf, speed, K, Vf, Vs, 950 * Vs)).epsilon(1e-5));
            // the order of the phases does not matter, nor whose speed it is
            const TimeStepInput swapped{H, 5e-4, 0.0, 0, 3, 8e-4, speed};
            CHECK(KernelRepulsion<>::time_step_limit(sponge(), water(), swapped, {.stiffness = K}) ==
                  Approx(limit).epsilon(1e-12));
        }
    const double Af = 8e-4 * 8e-4, As = 5e-4 * 5e-4;
    const TimeStepInput plane{H, 8e-4, 0.3, 0, 2, 5e-4, 0.0};
    CHECK(KernelRepulsion<>::time_step_limit(water(), sponge(), plane, {}) ==
          Approx(repulsion_limit_by_notes<2>(1000 * Af, 0.3, 1e8, Af, As, 950 * As)).epsilon(1e-5));
}

TEST_CASE("the limit of the repulsion within a phase is that of its stiffest pair") {
    const double V = std::pow(8e-4, 3), K = 1e4;
    for (const double range : {0.0, 0.7}) { // k = K V V 90/(pi H^5)
        const double reach = range > 0 ? range * 8e-4 : H, k = K * V * V * 90 / (pi * std::pow(reach, 5));
        const TimeStepInput in{H, 8e-4, 0.3, 0, 3, 0, 0};
        CHECK(KernelRepulsion<>::time_step_limit(water(), in, {.stiffness = K, .range = range}) ==
              Approx(std::sqrt(1000 * V / k)).epsilon(1e-3));
        CHECK(std::isinf(KernelRepulsion<>::time_step_limit(water(), in, {.stiffness = 0, .range = range})));
    }
}

/// The highest frequency of particles of a square or cubic lattice that repel each other, 1/s.
/// @param reach of the repulsion, in spacings of 8e-4 m, which is that of the support
template <int dim, class Kernel>
double lattice_frequency(double reach, double K) {
    using M = Eigen::Matrix<double, dim, dim>;
    using V = Eigen::Matrix<double, dim, 1>;
    const double spacing = 8e-4, R = reach * spacing, cell = std::pow(spacing, dim), step = 1e-5;
    const double scale = K * cell * cell * Kernel::template normalisation<dim>() / std::pow(R, dim); // J
    const int far = static_cast<int>(std::ceil(reach)), waves = dim == 2 ? 16 : 8;
    const auto for_each = [](int from, int to, const auto& f) { // all vectors of whole numbers
        for (int x = from; x <= to; ++x)
            for (int y = from; y <= to; ++y)
                for (int z = dim == 3 ? from : 0; z <= (dim == 3 ? to : 0); ++z)
                    f(Eigen::Vector3d(x, y, z).template head<dim>().eval());
    };
    std::vector<std::pair<V, M>> pairs;
    for_each(-far, far, [&](const V& x) {
        const double q = x.norm() / reach;
        if (q > 0 && q < 1 - step) {
            const M along = x * x.transpose() / x.squaredNorm();
            const double curvature = (Kernel::derivative(q + step) - Kernel::derivative(q - step)) / (2 * step);
            pairs.push_back(
                {x, scale / (R * R) * (curvature * along + Kernel::derivative(q) / q * (M::Identity() - along))});
        }
    });
    double highest = 0;
    for_each(0, waves, [&](const V& wave) {
        M sum = M::Zero();
        for (const auto& [x, stiffness] : pairs)
            sum += (1 - std::cos(pi / waves * wave.dot(x))) * stiffness;
        highest = std::max(highest, imbibe_test::greatest_eigenvalue(sum));
    });
    return std::sqrt(highest / (1000 * cell));
}
template <int dim, class Kernel>
void check_limit_on_lattices(double least, double most) {
    const double K = 1e4, spacing = 8e-4;
    for (const double reach : {1.1, 1.25, 1.5, 1.75, 2.0, 2.6, 3.0, 4.0}) {
        CAPTURE(dim, reach);
        const TimeStepInput in{reach * spacing, spacing, 0.3, 0, dim, 0, 0};
        const double limit = KernelRepulsion<Kernel>::time_step_limit(water(), in, {.stiffness = K});
        const double share = 0.5 * limit * lattice_frequency<dim, Kernel>(reach, K);
        CHECK(share < most); // stable is what is below 1
        CHECK((share > least || reach < 1.5));
    }
}

TEST_CASE("the limit of the repulsion within a phase is below the fastest wave of a lattice, not far") {
    check_limit_on_lattices<2, Spiky>(0.45, 0.56);
    check_limit_on_lattices<3, Spiky>(0.4, 0.56);
    check_limit_on_lattices<2, WendlandC2>(0.25, 0.45);
    check_limit_on_lattices<3, WendlandC2>(0.25, 0.45);
}

TEST_CASE("the limit of the repulsion knows how near a pair is") {
    const double Vf = std::pow(8e-4, 3), Vs = std::pow(5e-4, 3), K = 1e6,
                 m = 950 * Vs * 1000 * Vf / (950 * Vs + 1000 * Vf);
    TimeStepInput rest{H, 8e-4, 0, 0, 3, 5e-4, 0};
    const auto limit = [&] { return KernelRepulsion<>::time_step_limit(water(), sponge(), rest, {.stiffness = K}); };
    for (const double q : {0.9, 0.5, 0.1}) { // at rest, at q supports: k = K V V 90/(pi H^5) (1 - q)
        rest.nearest = q * H;
        const double k = K * Vf * Vs * 90 / (pi * std::pow(H, 5)) * (1 - q);
        CHECK(limit() == Approx(2 * std::sqrt(m / k)).epsilon(1e-4));
    }
    rest.nearest = 1.01 * H;
    CHECK(std::isinf(limit()));
    // and near as well as moving is as moving from afar with the energy of both
    rest.nearest = 0.5 * H;
    rest.max_speed = 0.3;
    const double stored = K * Vf * Vs * 15 / (pi * std::pow(H, 3)) * std::pow(0.5, 3);
    const double both = std::sqrt(sq(0.3) + 2 * stored / (1000 * Vf));
    CHECK(limit() == Approx(repulsion_limit_by_notes<3>(1000 * Vf, both, K, Vf, Vs, 950 * Vs)).epsilon(1e-4));
}

TEST_CASE("the limit of the repulsion at its ends: at rest, and faster than it can hold") {
    const TimeStepInput rest{H, 8e-4, 0, 0, 3, 5e-4, 0};
    CHECK(std::isinf(KernelRepulsion<>::time_step_limit(water(), sponge(), rest, {})));
    const double Vf = std::pow(8e-4, 3), Vs = std::pow(5e-4, 3);
    const TimeStepInput fast{H, 8e-4, 1e4, 0, 3, 5e-4, 0};
    CHECK(KernelRepulsion<>::time_step_limit(water(), sponge(), fast, {}) ==
          Approx(repulsion_limit_by_notes<3>(1000 * Vf, 1e4, 1e8, Vf, Vs, 950 * Vs)).epsilon(1e-3));
    CHECK(std::isinf(KernelRepulsion<>::time_step_limit(water(), sponge(), fast, {.stiffness = 0})));
    CHECK(KernelRepulsion<WendlandC2>::time_step_limit(water(), sponge(), fast, {}) > 0);
    CHECK(std::string_view(KernelRepulsion<>::limit_name) == "repulsion stiffness");
}

} // namespace coupling_test
