// TransportAdvection: nothing where nothing is shifted or nothing flows, (delta v . grad) v inside a sheared fluid.
#include "cloud.hpp"

#include <imbibe/fluid/transport_advection.hpp>

namespace transport_advection_test {

using namespace cloud;

namespace {

using Term = TransportAdvection<WendlandC2>;

/// Nine particles each way, three spacings of support, all shifted by the same velocity; `flow` gives theirs.
template <int dim>
auto shifted(const ColumnVector<dim>& shift, const auto& flow) {
    const Water water{.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 3e-3, .spacing = 1e-3};
    auto fluid = block<dim>(water, 9, 0);
    for (auto& p : fluid)
        p.set(transport_correction, vec<dim>(shift)).set(velocity, vec<dim>(flow(plain(p[position]))));
    return fluid;
}

template <int dim>
void check_shear() {
    const ColumnVector<dim> shift = ColumnVector<dim>::LinSpaced(0.3, -0.2);
    const Matrix<dim> slope = 40 * Matrix<dim>::Identity() + 10 * Matrix<dim>::Ones();
    const ColumnVector<dim> stream = ColumnVector<dim>::Constant(2);
    const auto sheared =
        shifted<dim>(shift, [&](const ColumnVector<dim>& x) { return ColumnVector<dim>(stream + slope * x); });
    const auto& centre = sheared[sheared.size() / 2];
    const ColumnVector<dim> expected = slope * shift;
    // a lattice of three spacings of support has 1.00 of a gradient (docs/stability_tables.md, "Gradient of x")
    CHECK((plain(sum(Term{}, centre, sheared)) - expected).norm() < 0.005 * expected.norm());

    const auto uniform = shifted<dim>(shift, [&](const ColumnVector<dim>&) { return stream; });
    const auto resting = shifted<dim>(ColumnVector<dim>::Zero(),
                                      [&](const ColumnVector<dim>& x) { return ColumnVector<dim>(slope * x); });
    for (const auto* fluid : {&uniform, &resting})
        for (const auto& p : *fluid)
            CHECK(plain(sum(Term{}, p, *fluid)).norm() == 0);
}

// One pair by hand: the volume is that which the neighbour has now.
template <int dim>
void check_by_hand() {
    const auto fluid =
        shifted<dim>(ColumnVector<dim>::LinSpaced(0.3, -0.2), [](const ColumnVector<dim>& x) { return 40 * x; });
    auto a = fluid[0], b = fluid[1];
    a.set(density, 980.0);
    b.set(density, 1030.0);
    const ColumnVector<dim> x = plain(a[position]) - plain(b[position]);
    const double slope = -20 * (dim == 2 ? 7 / pi : 21 / (2 * pi)) / std::pow(3e-3, dim + 2) * std::pow(2.0 / 3, 3);
    const ColumnVector<dim> expected = plain(b[mass]) / 1030 * slope * plain(a[transport_correction]).dot(x) *
                                       (plain(b[velocity]) - plain(a[velocity]));
    CHECK((plain(Term{}(a, b, geometry<Term, dim>(a, b))) - expected).norm() < 1e-11 * expected.norm());
}

} // namespace

TEST_CASE("TransportAdvection is the shift along the gradient of the velocity, and nothing where one is missing") {
    check_shear<2>();
    check_shear<3>();
}
TEST_CASE("TransportAdvection is its equation, pair by pair") {
    check_by_hand<2>();
    check_by_hand<3>();
}

} // namespace transport_advection_test
