// Laws of viscosity by their closed forms, and the terms that follow them by hand.
#include "cloud.hpp"

#include <imbibe/fluid/generalised_newtonian.hpp>
#include <imbibe/fluid/morris_viscosity.hpp>
#include <imbibe/wall/generalised_no_slip.hpp>

#include <catch_shim.hpp>

#include <cmath>

namespace generalised_newtonian_test {

using namespace cloud;
using K = WendlandC2;
using Term = GeneralisedNewtonianViscosity<HerschelBulkley, K>;

constexpr CarreauParameters blood{.at_rest = 0.056, .fast = 0.00345, .time = 3.313, .exponent = 0.3568};
constexpr HerschelBulkleyParameters paste{
    .consistency = 2, .exponent = 0.5, .yield_stress = 3, .sharpness = 50, .least_rate = 0.01};

TEST_CASE("Carreau's liquid thins from one viscosity to the other") {
    CHECK(Carreau::viscosity(blood, 0.0) == Approx(0.056));
    CHECK(Carreau::viscosity(blood, 1e12) == Approx(0.00345).epsilon(1e-3));
    // Far above 1/lambda it is a power law: a decade of rates is n - 1 decades of what is above eta_inf.
    const double one = Carreau::viscosity(blood, 1e3) - blood.fast, other = Carreau::viscosity(blood, 1e4) - blood.fast;
    CHECK(std::log10(other / one) == Approx(blood.exponent - 1).epsilon(1e-5));
    CHECK(Carreau::viscosity(blood, 2.0) == Approx(0.00345 + 0.05255 * std::pow(1 + std::pow(6.626, 2), -0.3216)));
    CHECK(Carreau::viscosity(CarreauParameters{.at_rest = 1, .time = 1, .exponent = 0.5, .transition = 1}, 3.0) ==
          Approx(0.5)); // Yasuda
    CHECK(plain(Carreau::viscosity(blood, Number<double>(2.0))) == Approx(Carreau::viscosity(blood, 2.0)));
    CHECK_THROWS_WITH(
        CarreauParameters{}.check("Blood"),
        imbibe_test::contains("Blood: CarreauParameters::at_rest = 0 Pa s; it must be a finite number above"));
    CHECK_THROWS_WITH((CarreauParameters{.at_rest = 1, .exponent = 0}.check("Blood")),
                      imbibe_test::contains("exponent = 0; it must be above 0 and at most 2"));
    CHECK_THROWS_WITH((CarreauParameters{.at_rest = 1, .fast = -1}.check("Blood")), imbibe_test::contains("fast = -1"));
    CHECK_THROWS_WITH((CarreauParameters{.at_rest = 1, .transition = 0}.check("Blood")),
                      imbibe_test::contains("transition = 0; it must be finite and above 0"));
}

TEST_CASE("A paste of Herschel and Bulkley bears its yield stress and flows by its power") {
    // The stress beyond the sharp beginning.
    for (const double rate : {1.0, 10.0, 1000.0})
        CHECK(HerschelBulkley::viscosity(paste, rate) * rate == Approx(3 + 2 * std::sqrt(rate)).epsilon(1e-12));
    // At rest: tau_0 m + K/sqrt(least rate), finite; and smooth where the exponential is replaced by its series.
    CHECK(HerschelBulkley::viscosity(paste, 0.0) == Approx(150 + 20));
    for (const double x : {0.0499999, 0.0500001})
        CHECK(HerschelBulkley::viscosity(paste, x / 50) ==
              Approx(20 + 3 * (1 - std::exp(-x)) / (x / 50)).epsilon(1e-5));
    CHECK(HerschelBulkley::viscosity(HerschelBulkleyParameters{.consistency = 2}, 7.0) == Approx(2)); // Newton's
    CHECK_THROWS_WITH(HerschelBulkleyParameters{}.check("Paste"), imbibe_test::contains("consistency = 0 Pa s^n"));
    CHECK_THROWS_WITH(
        (HerschelBulkleyParameters{.consistency = 1, .yield_stress = 2}.check("Paste")),
        imbibe_test::contains("sharpness = 0 s with a yield stress of 2 Pa; give some 100 over the rate"));
    CHECK_THROWS_WITH((HerschelBulkleyParameters{.consistency = 1, .exponent = 3}.check("Paste")),
                      imbibe_test::contains("exponent = 3"));
    CHECK_THROWS_WITH((HerschelBulkleyParameters{.consistency = 1, .least_rate = 0}.check("Paste")),
                      imbibe_test::contains("least_rate = 0 1/s"));
}

/// A block in shear of that rate, with volumes and viscosities.
template <int dim>
Cloud<dim, Water> sheared(double rate) {
    Water material = water();
    material.spacing = 1e-3;
    material.support_radius = 3e-3;
    auto fluid = block<dim>(material, 9, 0);
    for (auto& p : fluid) {
        auto v = Vector<Number<double>, dim>::zero();
        v[0] = rate * p[position][1];
        p.set(velocity, v).set(volume, p[mass] / p[density]);
    }
    return fluid;
}

template <int dim>
void check_in_shear() {
    const double rate = 4;
    auto fluid = sheared<dim>(rate);
    auto a = fluid[fluid.size() / 2];
    a.set(strain_rate, sum(Term::Sum{}, a, fluid));
    const Matrix<dim> E = plain(a[strain_rate]);
    CHECK(E(0, 1) == Approx(0.5 * rate).epsilon(0.02)); // the error of the lattice sum
    CHECK(std::abs(E(0, 0)) < 1e-12 * rate);
    const double gamma = std::sqrt(2 * E.squaredNorm());
    CHECK(plain(Term::Follow{paste}(a)) == Approx(HerschelBulkley::viscosity(paste, gamma)));
    // A pair: Morris' force with the harmonic mean.
    auto b = fluid[fluid.size() / 2 + 1];
    a.set(apparent_viscosity, 3.0);
    b.set(apparent_viscosity, 1.0);
    b.set(velocity, Vector<Number<double>, dim>::filled(0.3));
    const auto ab = geometry<Term::Push, dim>(a, b);
    const ColumnVector<dim> found = plain(Term::Push{}(a, b, ab)),
                            back = plain(Term::Push{}(b, a, geometry<Term::Push, dim>(b, a)));
    Water newtonian = a.material;
    newtonian.viscosity = 1.5;
    auto na = a, nb = b;
    na.material = nb.material = newtonian;
    const ColumnVector<dim> expected = plain(MorrisViscosity<K>{}(na, nb, ab));
    CHECK((found - expected).norm() < 1e-12 * expected.norm());
    CHECK((found + back).norm() < 1e-14 * found.norm());
}

TEST_CASE("The viscosity follows the rate of shear, and pairs take the harmonic mean") {
    check_in_shear<2>();
    check_in_shear<3>();
}

TEST_CASE("The limit of a liquid that follows a law is that of its greatest viscosity") {
    const TimeStepInput in{
        .support_radius = 3e-3, .spacing = 1e-3, .max_speed = 0, .max_acceleration = 0, .dimension = 2};
    Water material = water();
    material.viscosity = HerschelBulkley::viscosity(paste, 0.0);
    CHECK(Term::time_step_limit(material, in, paste) == Approx(MorrisViscosity<K>::time_step_limit(material, in)));
    TimeStepInput flowing = in;
    flowing.greatest = 0.1 * material.viscosity;
    CHECK(Term::time_step_limit(material, flowing, paste) == Approx(10 * Term::time_step_limit(material, in, paste)));
}

TEST_CASE("At a wall a liquid that follows a law sees the wall's shown velocity and its own viscosity") {
    const auto fluid = sheared<2>(4);
    auto a = fluid[fluid.size() / 2];
    Particle<2, Number<double>, Sponge> b(sponge());
    auto place = a[position];
    place[1] -= 1e-3;
    b.set(position, place).set(velocity, Vector<Number<double>, 2>::zero()).set(mass, 1e-3).set(density, 1000.0);
    b.set(volume, 1e-6).set(no_slip_velocity, Vector<Number<double>, 2>::filled(-0.5));
    a.set(apparent_viscosity, 3.0).set(volume, 1e-6);
    const auto ab = geometry<NoSlipStrainRate<K>::Sum, 2>(a, b);
    const Matrix<2> E = plain(NoSlipStrainRate<K>::Sum{}(a, b, ab));
    const double slope = plain(ab.gradient(K{})), y = 1e-3;
    const ColumnVector<2> apart = ColumnVector<2>::Constant(-0.5) - plain(a[velocity]);
    CHECK(E(0, 1) == Approx(0.5e-6 * slope * apart[0] * y));
    CHECK(E(1, 1) == Approx(1e-6 * slope * apart[1] * y));
    const ColumnVector<2> force = plain(NoSlipApparentViscosity<K>{}(a, b, ab));
    const ColumnVector<2> expected = -(2 * 3.0 * 1e-3 / (plain(a[density]) * 1000) * slope) * apart;
    CHECK((force - expected).norm() < 1e-12 * expected.norm());
}

} // namespace generalised_newtonian_test
