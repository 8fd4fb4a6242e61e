// The terms of the fluid against the equations written out: continuity, pressure, viscosities.
#include "hand.hpp"

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/laminar_viscosity.hpp>
#include <imbibe/fluid/monaghan_viscosity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/kernels.hpp>

#include <eigenvalues.hpp>

namespace fluid_test {

using namespace hand;

namespace {

constexpr double tight = 1e-11;

template <int dim>
using LaplacianKernel = std::conditional_t<dim == 3, ViscosityKernel, ViscosityKernel2D>;

template <int dim>
void check_continuity() {
    Dice dice(dim);
    auto all = dice.cluster<dim>(water());
    prepare(Volume{}, volume, all);
    const auto& a = all.front();
    for (const bool smooth : {false, true}) {
        const auto v = [smooth](const auto& p) { return plain(smooth ? p[smoothed_velocity] : p[velocity]); };
        const double by_mass = sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double) {
            return plain(b[mass]) * (v(a) - v(b)).dot(spiky_gradient<dim>(x));
        });
        const double by_volume = sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double) {
            return plain(a[density]) * plain(b[mass]) / plain(b[density]) * (v(a) - v(b)).dot(spiky_gradient<dim>(x));
        });
        const double one = smooth ? plain(sum_over_neighbours(Continuity<Spiky, smoothed_velocity>{}, all))
                                  : plain(sum_over_neighbours(Continuity<Spiky>{}, all));
        const double two = smooth ? plain(sum_over_neighbours(VolumeContinuity<Spiky, smoothed_velocity>::Sweep{}, all))
                                  : plain(sum_over_neighbours(VolumeContinuity<Spiky>::Sweep{}, all));
        CHECK(relative_error(one, by_mass) < tight);
        CHECK(relative_error(two, by_volume) < tight);
        CHECK(relative_error(by_mass, by_volume) > 1e-4); // the two forms are not the same
    }
}

template <int dim>
void check_pressure() {
    Dice dice(10 + dim);
    auto all = dice.cluster<dim>(water());
    prepare(SymmetricPressure<Spiky>::Prepare{}, pressure_over_density2, all);
    const auto& a = all.front();
    const double rho = plain(a[density]);
    CHECK(plain(a[pressure_over_density2]) == Approx(plain(a[pressure]) / (rho * rho)).epsilon(1e-14));
    const ColumnVector<dim> by_hand =
        sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double) -> ColumnVector<dim> {
            const double pa = plain(a[pressure]), pb = plain(b[pressure]), rho_b = plain(b[density]);
            return -plain(b[mass]) * (pa / (rho * rho) + pb / (rho_b * rho_b)) * spiky_gradient<dim>(x);
        });
    CHECK(relative_error(plain(sum_over_neighbours(SymmetricPressure<Spiky>::Push{}, all)), by_hand) < tight);
}

template <int dim>
void check_laminar_viscosity() {
    Dice dice(20 + dim);
    const auto all = dice.cluster<dim>(water());
    const auto& a = all.front();
    const ColumnVector<dim> by_hand =
        sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>&, double r) -> ColumnVector<dim> {
            return 3.5e-3 / plain(a[density]) * plain(b[mass]) / plain(b[density]) *
                   (plain(b[velocity]) - plain(a[velocity])) * viscosity_laplacian<dim>(r);
        });
    const LaminarViscosity<LaplacianKernel<dim>> term;
    CHECK(relative_error(plain(sum_over_neighbours(term, all)), by_hand) < tight);
    // the mended sign takes energy: the relative motion of a pair is braked
    const auto ab = pair_of(a, all[1]);
    CHECK(plain(dot(term(a, all[1], ab), a[velocity] - all[1][velocity])) < 0);
}

template <int dim>
void check_artificial_viscosity(double alpha, double beta) {
    Dice dice(30 + dim);
    const auto all = dice.cluster<dim>(sponge(), 20);
    const auto& a = all.front();
    int approaching = 0, receding = 0;
    // the paper's sign: plus before the sum, Pi = + alpha c mu / rho for mu < 0; beta with the same sign as |mu| alpha
    const ColumnVector<dim> by_hand =
        sum_by_hand(all, [&](const auto& b, const ColumnVector<dim>& x, double r) -> ColumnVector<dim> {
            const double mu = H * (plain(a[velocity]) - plain(b[velocity])).dot(x) / (r * r + 0.01 * H * H);
            const double rho = (plain(a[density]) + plain(b[density])) / 2;
            ++(mu < 0 ? approaching : receding);
            const double Pi = mu < 0 ? (alpha * 31.6 * mu - beta * mu * mu) / rho : 0;
            return plain(b[mass]) * Pi * spiky_gradient<dim>(x);
        });
    MonaghanViscosity<Spiky> term;
    term.parameters = {.alpha = alpha, .beta = beta};
    CHECK(relative_error(plain(sum_over_neighbours(term, all)), by_hand) < tight);
    CHECK(approaching > 2);
    CHECK(receding > 2);
}

/// Calls f(x) for the places x of a lattice within a support around one of its points, that one left out.
template <int dim, class F>
void for_each_on_lattice(double spacing, const F& f) {
    const int reach = static_cast<int>(std::ceil(1 / spacing)), depth = dim == 3 ? reach : 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (int l = -depth; l <= depth; ++l) {
                const Eigen::Vector3d x = spacing * H * Eigen::Vector3d(i, j, l);
                if (x.norm() > 0 && x.norm() < H)
                    f(x);
            }
}
/// The wave numbers 0, half and all of the shortest wave's, 1/m.
template <int dim, class F>
void for_each_wave(double spacing, const F& f) {
    for (int code = 0; code < (dim == 3 ? 27 : 9); ++code)
        f(Eigen::Vector3d(code % 3, code / 3 % 3, code / 9) * (pi / 2 / (spacing * H)));
}

/// The stable step of the wave that viscosity damps fastest on a lattice, over the limit that the term gives.
template <int dim>
double room_under_the_viscous_limit(double spacing) {
    double fastest = 0;
    for_each_wave<dim>(spacing, [&](const Eigen::Vector3d& k) {
        double rate = 0;
        for_each_on_lattice<dim>(spacing, [&](const Eigen::Vector3d& x) {
            rate += 3.5e-6 * std::pow(spacing * H, dim) * viscosity_laplacian<dim>(x.norm()) * (1 - std::cos(k.dot(x)));
        });
        fastest = std::max(fastest, rate);
    });
    const TimeStepInput in{H, spacing * H, 0, 0, dim};
    return 2 / fastest / LaminarViscosity<LaplacianKernel<dim>>::time_step_limit(water(), in);
}

/// The stable step of the fastest damped wave on a lattice, over the limit that the term gives: at least 1, not much
/// more. A wave exp(i k x) with amplitude u is braked by sum_b g(x_b) (1 - cos k x_b) n n^T u, g from the term itself;
/// half of it, because half of the neighbours recede.
template <int dim, class Kernel>
double room_under_the_limit(double spacing) {
    MonaghanViscosity<Kernel> term;
    Water material = water();
    material.spacing = spacing * H;
    Particle<dim> a(material), b(material);
    const double m = material.density * std::pow(spacing * H, dim);
    a.set(mass, m).set(density, material.density).set(position, Vector<Number<double>, dim>::zero());
    b.set(mass, m).set(density, material.density).set(velocity, Vector<Number<double>, dim>::zero());
    double fastest = 0;
    for_each_wave<dim>(spacing, [&](const Eigen::Vector3d& k) {
        Matrix<dim> brake = Matrix<dim>::Zero();
        for_each_on_lattice<dim>(spacing, [&](const Eigen::Vector3d& x) {
            const ColumnVector<dim> n = x.normalized().template head<dim>();
            b.set(position, from_eigen<Number<double>, dim>(x.template head<dim>()));
            a.set(velocity, from_eigen<Number<double>, dim>(n)); // towards b at unit speed
            const auto ab = pair_of(a, b);
            const ColumnVector<dim> push = plain(contribution(ab, term(a, b, ab)));
            brake += 0.5 * push.norm() * (1 - std::cos(k.dot(x))) * n * n.transpose();
        });
        fastest = std::max(fastest, imbibe_test::greatest_eigenvalue(brake));
    });
    const TimeStepInput in{H, spacing * H, 0, 0, dim};
    return 2 / fastest / MonaghanViscosity<Kernel>::time_step_limit(material, in, {});
}

template <class Kernel>
void check_room_under_the_limit() {
    for (const double spacing : {0.25, 0.3, 1.0 / 3, 0.4, 0.5, 0.6, 0.8}) {
        UNSCOPED_INFO(Kernel::name << " " << spacing);
        CHECK(room_under_the_limit<2, Kernel>(spacing) > 1);
        CHECK(room_under_the_limit<3, Kernel>(spacing) > 1);
    }
    CHECK(room_under_the_limit<2, Kernel>(1.0 / 3) < 1.5); // and not timid
    CHECK(room_under_the_limit<3, Kernel>(1.0 / 3) < 1.5);
}

} // namespace

TEST_CASE("Continuity and VolumeContinuity are Eq. (11) by mass and by volume") {
    check_continuity<2>();
    check_continuity<3>();
}

TEST_CASE("Continuity: approach means compression") {
    Particle<3> a(water()), b(water());
    a.set(mass, 1e-6).set(density, 1000).set(velocity, {1, 0, 0}).set(position, {0, 0, 0});
    b.set(mass, 1e-6).set(density, 1000).set(velocity, {-1, 0, 0}).set(position, {5e-4, 0, 0});
    CHECK(plain(Continuity<Spiky>{}(a, b, pair_of(a, b))) > 0);
    for (auto* p : {&a, &b})
        p->set(volume, Volume{}(*p));
    CHECK(plain(VolumeContinuity<Spiky>::Sweep{}(b, a, pair_of(b, a))) > 0);
}

TEST_CASE("SymmetricPressure is the pressure part of Eq. (12)") {
    check_pressure<2>();
    check_pressure<3>();
}

TEST_CASE("LaminarViscosity is the mended viscous part of Eq. (12)") {
    check_laminar_viscosity<2>();
    check_laminar_viscosity<3>();
}

TEST_CASE("the viscosity of a pair of materials is the same from both sides") {
    Water oil = water(), clear = water();
    oil.viscosity = 0.1;
    clear.viscosity = 0;
    CHECK(detail::pair_viscosity(oil, oil) == 0.1);
    CHECK(detail::pair_viscosity(oil, water()) == Approx(2 / (1 / 0.1 + 1 / 3.5e-3)).epsilon(1e-13));
    CHECK(detail::pair_viscosity(oil, water()) == detail::pair_viscosity(water(), oil));
    CHECK(detail::pair_viscosity(sponge(), oil) == 0.1);
    CHECK(detail::pair_viscosity(oil, sponge()) == 0.1);
    CHECK(detail::pair_viscosity(clear, oil) == 0);
    CHECK(detail::pair_viscosity(clear, clear) == 0);
}

TEST_CASE("the limits of the viscosities") {
    const TimeStepInput in{H, 5e-4, 2, 0, 3, 8e-4, 1};
    CHECK(LaminarViscosity<>::time_step_limit(water(), in) == Approx(0.105 * H * H * 1000 / 3.5e-3).epsilon(1e-12));
    CHECK(LaminarViscosity<>::time_step_limit(water(), sponge(), in) ==
          Approx(0.105 * H * H * 950 / 3.5e-3).epsilon(1e-12));
    CHECK(LaminarViscosity<ViscosityKernel2D>::time_step_limit(water(), TimeStepInput{H, 5e-4, 2, 0, 2}) ==
          Approx(0.125 * H * H * 1000 / 3.5e-3).epsilon(1e-12));
    Water inviscid = water();
    inviscid.viscosity = 0;
    CHECK(std::isinf(LaminarViscosity<>::time_step_limit(inviscid, in)));
    CHECK(std::string_view(LaminarViscosity<>::limit_name) == "viscosity");

    using Artificial = MonaghanViscosity<Spiky>;
    const double share = 0.49406; // 2/(0.31 S), S = 13.0583 by adaptive quadrature
    CHECK(Artificial::time_step_limit(sponge(), in, {.alpha = 2}) == Approx(share * H / (2 * 31.6)).epsilon(1e-4));
    CHECK(Artificial::time_step_limit(sponge(), TimeStepInput{H, 5e-4, 2, 0, 3}, {.alpha = 1, .beta = 2}) ==
          Approx(share * H / (31.6 + 16)).epsilon(1e-4));
    CHECK(std::isinf(Artificial::time_step_limit(sponge(), in, {.alpha = 0})));
    CHECK(std::string_view(Artificial::limit_name) == "artificial viscosity");
}

TEST_CASE("the limit of LaminarViscosity damps every wave on a lattice stably") {
    for (const double spacing : {0.25, 1.0 / 3, 0.5, 1 / 1.5, 1 / 1.3, 0.8}) {
        INFO(spacing);
        CHECK(room_under_the_viscous_limit<2>(spacing) > 1);
        CHECK(room_under_the_viscous_limit<3>(spacing) > 1);
        CHECK(room_under_the_viscous_limit<2>(spacing) < 1.3);
        CHECK(room_under_the_viscous_limit<3>(spacing) < 1.3);
    }
}

TEST_CASE("MonaghanViscosity is Eq. (16) in the paper's signs, with beta") {
    check_artificial_viscosity<2>(1, 0);
    check_artificial_viscosity<3>(1, 0);
    check_artificial_viscosity<3>(0.7, 1.4);
}

TEST_CASE("MonaghanViscosity pushes what approaches apart and leaves the rest alone") {
    Particle<3> a(water()), b(water());
    a.set(mass, 1e-6).set(density, 1000).set(velocity, {1, 0.3, 0}).set(position, {0, 0, 0});
    b.set(mass, 1e-6).set(density, 1000).set(velocity, {-1, 0, 0}).set(position, {5e-4, 0, 0});
    const MonaghanViscosity<Spiky> term;
    const auto ab = pair_of(a, b);
    CHECK(plain(contribution(ab, term(a, b, ab)))[0] < 0); // b is on the right: a is pushed to the left
    a.set(velocity, {-2, 0, 0});
    CHECK(plain(term(a, b, ab).factor) == 0);
}

TEST_CASE("the limit of MonaghanViscosity damps every wave on a lattice stably") {
    check_room_under_the_limit<Spiky>();
    check_room_under_the_limit<Poly6>();
    check_room_under_the_limit<CubicSpline>();
    check_room_under_the_limit<QuinticSpline>();
    check_room_under_the_limit<WendlandC2>();
    check_room_under_the_limit<WendlandC4>();
    check_room_under_the_limit<WendlandC6>();
}

} // namespace fluid_test
