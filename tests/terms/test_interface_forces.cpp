// ModifiedRepulsion and the surface-normal coupling against their equations written out, and against what they promise.
#include "cloud.hpp"

#include <imbibe/coupling/modified_repulsion.hpp>
#include <imbibe/coupling/surface_normal.hpp>
#include <imbibe/kernels/wendland.hpp>

#include <Eigen/Dense>

namespace interface_forces_test {

using namespace cloud;

namespace {

Water liquid() {
    return {.density = 1000, .sound_speed = 30, .support_radius = 3e-3, .spacing = 1e-3};
}
Sponge soft() {
    return {.density = 950, .sound_speed = 10, .shear_modulus = 1e4, .support_radius = 3e-3, .spacing = 1e-3};
}
template <int dim>
ColumnVector<dim> along_x(double x) {
    ColumnVector<dim> v = ColumnVector<dim>::Zero();
    v[0] = x;
    return v;
}
constexpr double reach = 3e-3;

// The gradient of Wendland's C2 kernel by hand.
template <int dim>
ColumnVector<dim> wendland_gradient(const ColumnVector<dim>& x) {
    const double q = x.norm() / reach, norm = dim == 2 ? 7 / pi : 21 / (2 * pi);
    return q < 1 && q > 0
               ? ColumnVector<dim>(-norm / std::pow(reach, dim + 1) * 20 * q * std::pow(1 - q, 3) * x / x.norm())
               : ColumnVector<dim>::Zero();
}

template <int dim>
void check_repulsion() {
    Dice dice(1);
    auto fluid = block<dim>(liquid(), 3, 0.3, 1);
    auto solid = block<dim>(soft(), 3, 0.3, 2, ColumnVector<dim>::Constant(0.4e-3));
    for (auto* all : {&fluid})
        for (auto& p : *all)
            p.set(velocity, dice.vector<dim>(1));
    for (auto& p : solid)
        p.set(velocity, dice.vector<dim>(1));
    ModifiedRepulsion push{{.speed = 2, .range = 0.9, .restitution = 0.5}};
    int near = 0, parting = 0;
    for (const auto& a : fluid)
        for (const auto& b : solid) {
            const ColumnVector<dim> x = plain(a[position]) - plain(b[position]),
                                    v = plain(a[velocity]) - plain(b[velocity]);
            const double r = x.norm(), r0 = 0.9e-3, share = v.dot(x) > 0 ? 0.25 : 1, m = plain(b[mass]);
            const ColumnVector<dim> expected = r < r0 ? ColumnVector<dim>(m / (m + plain(a[mass])) * 1.5 * 4 / r0 *
                                                                          std::pow(1 - r / r0, 2) * share * x / r)
                                                      : ColumnVector<dim>::Zero();
            const ColumnVector<dim> got = given(push, a, b) / plain(a[mass]);
            CHECK((got - expected).norm() <= 1e-12 * expected.norm());
            near += r < r0;
            parting += r < r0 && share < 1;
        }
    CHECK(near > 5);
    CHECK(parting > 2);
    CHECK(parting < near);
    CHECK(worst_imbalance(push, fluid, solid) < 1e-14);
}

/// The speed at which a pair parts after it has met with `speed` along its line; negative: it went through.
double rebound(const ModifiedRepulsion& push, double speed, double dt) {
    auto a = block<2>(liquid(), 1, 0).front();
    auto b = block<2>(soft(), 1, 0, 1, along_x<2>(1.5e-3)).front();
    a.set(velocity, vec<2>(along_x<2>(speed)));
    for (int k = 0; k < 100000; ++k) {
        const auto fa = sum(push, a, Cloud<2, Sponge>{b});
        const auto fb = sum(push, b, Cloud<2, Water>{a});
        a.set(velocity, a[velocity] + Number<double>(dt) * fa);
        b.set(velocity, b[velocity] + Number<double>(dt) * fb);
        a.set(position, a[position] + Number<double>(dt) * a[velocity]);
        b.set(position, b[position] + Number<double>(dt) * b[velocity]);
        const double apart = plain(b[position])[0] - plain(a[position])[0];
        const double v = plain(b[velocity])[0] - plain(a[velocity])[0];
        if (apart < 0)
            return -1;
        if (apart > 1.2e-3 && v > 0)
            return v;
        if (k * dt > 5e-3)
            return v; // it stays
    }
    return -2;
}

/// A block of the solid with its normals, from either kind of neighbours, deformed by F.
template <int dim>
Cloud<dim, Sponge> slab(const Matrix<dim>& F, bool from_reference) {
    auto body = block<dim>(soft(), dim == 2 ? 9 : 7, 0);
    for (auto& p : body)
        p.set(deformation_gradient, tensor<dim>(F)).set(position, vec<dim>(F * plain(p[reference_position])));
    if (from_reference) {
        gather(ReferenceSurfaceNormal<>::Sum{}, surface_normal_sum, body, body);
        prepare(ReferenceSurfaceNormal<>::Turn{}, surface_normal, body);
    } else {
        gather(SurfaceNormal<>::Sum{}, surface_normal_sum, body, body);
        prepare(SurfaceNormal<>::Unit{}, surface_normal, body);
    }
    return body;
}

template <int dim>
void check_normals() {
    const int n = dim == 2 ? 9 : 7;
    const auto at = [&](int i, int j) {
        return static_cast<std::size_t>(i + n * j + (dim == 3 ? n * n * (n / 2) : 0));
    };
    const Matrix<dim> one = Matrix<dim>::Identity();
    for (const bool reference : {false, true}) {
        const auto body = slab<dim>(one, reference);
        CHECK((plain(body[at(0, n / 2)][surface_normal]) - along_x<dim>(-1)).norm() < 1e-12);
        CHECK((plain(body[at(n - 1, n / 2)][surface_normal]) - along_x<dim>(1)).norm() < 1e-12);
        CHECK(plain(body[at(n / 2, n / 2)][surface_normal]).norm() == 0); // inside
        const ColumnVector<dim> corner = plain(body[at(0, 0)][surface_normal]);
        CHECK(corner[0] == Approx(-std::sqrt(0.5)));
        CHECK(corner[1] == Approx(-std::sqrt(0.5)));
    }
    // a stretched, sheared and turned solid: the normal stays at right angles to the deformed face
    Matrix<dim> F = one;
    F(0, 0) = 1.1, F(0, 1) = 0.4, F(1, 0) = 0.2;
    const auto body = slab<dim>(F, true);
    const ColumnVector<dim> normal = plain(body[at(0, n / 2)][surface_normal]);
    CHECK(normal.norm() == Approx(1));
    CHECK(normal[0] < 0);
    for (int d = 1; d < dim; ++d)
        CHECK(std::abs(normal.dot(F.col(d))) < 1e-12);
}

template <int dim>
void check_surface_pressure() {
    // by hand, pair by pair
    Dice dice(5);
    auto solid = slab<dim>(Matrix<dim>::Identity(), true);
    auto fluid = block<dim>(liquid(), dim == 2 ? 9 : 7, 0.2, 3, along_x<dim>(dim == 2 ? 9e-3 : 7e-3));
    for (auto& p : fluid)
        p.set(density, dice(990, 1010)).set(volume, p[mass] / p[density]).set(pressure, dice(-100, 500));
    for (auto& p : solid)
        p.set(volume, p[mass] / p[density]);
    const SurfaceNormalPressure<>::Push push;
    const double steep = wendland_gradient<dim>(along_x<dim>(1e-3)).norm(); // near the rim digits are lost in 1 - q
    double worst = 0;
    for (const auto& f : fluid)
        for (const auto& s : solid) {
            const ColumnVector<dim> g = wendland_gradient<dim>(plain(s[position]) - plain(f[position]));
            if (g.norm() == 0)
                continue;
            const ColumnVector<dim> n = plain(s[surface_normal]);
            const ColumnVector<dim> expected = -plain(f[volume]) * plain(s[volume]) * 2 * plain(f[pressure]) *
                                               (n * n.dot(g) + (1 - n.squaredNorm()) * g);
            worst = std::max(worst, (given(push, s, f) - expected).norm() /
                                        (plain(f[volume]) * plain(s[volume]) * 500 * steep));
        }
    CHECK(worst < 1e-12);
    CHECK(worst_imbalance(push, fluid, solid) < 1e-14);
}

// A flat face under a uniform pressure receives pressure times area, and nothing along the face.
template <int dim>
void check_force_on_a_face() {
    const int n = dim == 2 ? 9 : 7;
    auto solid = slab<dim>(Matrix<dim>::Identity(), true);
    auto fluid = block<dim>(liquid(), n, 0, 3, along_x<dim>(n * 1e-3));
    for (auto& p : fluid)
        p.set(volume, p[mass] / p[density]).set(pressure, 300.0);
    for (auto& p : solid)
        p.set(volume, p[mass] / p[density]);
    // what the middle row of the face bears, with all particles behind it
    ColumnVector<dim> force = ColumnVector<dim>::Zero();
    const SurfaceNormalPressure<>::Push push;
    for (const auto& s : solid) {
        bool middle = true;
        for (int d = 1; d < dim; ++d)
            middle = middle && std::abs(plain(s[position])[d] - 1e-3 * (n / 2)) < 1e-6;
        if (middle)
            force += plain(s[mass]) * plain(sum(push, s, fluid));
    }
    const double load = 300 * (dim == 2 ? 1e-3 : 1e-6);
    CAPTURE(force[0] / load);
    CHECK(force[0] == Approx(-load).epsilon(0.03)); // the sum over a lattice is not quite the integral
    CHECK(force.template tail<dim - 1>().norm() < 1e-12 * load);
}

} // namespace

TEST_CASE("ModifiedRepulsion is its equation, equal and opposite") {
    check_repulsion<2>();
    check_repulsion<3>();
}

TEST_CASE("ModifiedRepulsion reaches as far as the mean of two spacings says, at most the support radius") {
    auto fine = soft();
    fine.spacing = 0.4e-3; // 0.7e-3 m in the mean
    const auto push = [&](double distance, double range) {
        const auto a = block<2>(liquid(), 1, 0).front();
        const auto b = block<2>(fine, 1, 0, 1, along_x<2>(distance)).front();
        return plain(sum(ModifiedRepulsion{{.speed = 2, .range = range}}, a, Cloud<2, Sponge>{b}))[0];
    };
    const double share = 950 * sq(0.4e-3) / (950 * sq(0.4e-3) + 1000 * sq(1e-3)); // m_b/(m_a + m_b)
    CHECK(push(0.701e-3, 1) == 0);
    CHECK(push(0.35e-3, 1) == Approx(-share * 1.5 * 4 / 0.7e-3 * 0.25));
    CHECK(push(3.01e-3, 10) == 0);
    CHECK(push(1.5e-3, 10) == Approx(-share * 1.5 * 4 / reach * 0.25));
}

TEST_CASE("ModifiedRepulsion stops a pair below its speed, and gives back what it is told to") {
    constexpr double dt = 1e-7;
    CHECK(rebound({{.speed = 2, .range = 1, .restitution = 1}}, 1.5, dt) == Approx(1.5).epsilon(1e-3));
    CHECK(rebound({{.speed = 2, .range = 1, .restitution = 0.5}}, 1.5, dt) == Approx(0.75).epsilon(1e-2));
    CHECK(std::abs(rebound({{.speed = 2, .range = 1}}, 1.5, dt)) < 1e-2);
    CHECK(rebound({{.speed = 2, .range = 1}}, 2.1, dt) == -1); // too fast
    CHECK(rebound({{.speed = 2, .range = 1, .restitution = 1}}, 1.99, dt) == Approx(1.99).epsilon(1e-2));
}

TEST_CASE("ModifiedRepulsion: limits on the step and on its coefficients") {
    const TimeStepInput in{3e-3, 1e-3, 0.5, 0, 2, 1e-3, 0.25};
    const auto limit = [&](const TimeStepInput& now) {
        return ModifiedRepulsion::time_step_limit(liquid(), soft(), now, {.speed = 2, .range = 0.8});
    };
    const double depth = std::cbrt(sq(0.75 / 2));
    CHECK(limit(in) == Approx(0.8e-3 / std::sqrt(3 * depth)));
    TimeStepInput near = in, fast = in, still = in;
    near.nearest = 0.4e-3; // half the range
    CHECK(limit(near) == Approx(0.8e-3 / std::sqrt(3 * std::cbrt(0.125 + sq(0.75 / 2)))));
    fast.max_speed = 10;
    CHECK(limit(fast) == Approx(0.8e-3 / 10.25));
    still.max_speed = still.other_max_speed = 0;
    CHECK(std::isinf(limit(still)));
    CHECK(std::isinf(ModifiedRepulsion::time_step_limit(liquid(), soft(), in, {.speed = 0})));
    // A range beyond the support radius is one of the support radius.
    near.nearest = 0;
    const double whole = near.support_radius / (0.5 * (near.spacing + near.other_spacing));
    CHECK(ModifiedRepulsion::time_step_limit(liquid(), soft(), near, {.speed = 2, .range = 10 * whole}) ==
          ModifiedRepulsion::time_step_limit(liquid(), soft(), near, {.speed = 2, .range = whole}));
    // Within a phase it takes pairs of any depth, and is shorter for a wide range, in which a particle has many.
    TimeStepInput alone = in;
    alone.max_speed = 0;
    const double range = 0.8 * alone.spacing;
    CHECK(ModifiedRepulsion::time_step_limit(liquid(), alone, {.speed = 2, .range = 0.8}) ==
          Approx(range / std::sqrt(3.0)));
    const auto within = [&](double speed, int dimension) {
        TimeStepInput now = alone;
        now.max_speed = speed;
        now.dimension = dimension;
        return ModifiedRepulsion::time_step_limit(liquid(), now, {.speed = 2, .range = 2});
    };
    CHECK(within(0, 2) == Approx(1.25 / 2 * 2e-3 / std::sqrt(3.0)));
    CHECK(within(0, 3) == Approx(std::pow(1.25 / 2, 1.5) * 2e-3 / std::sqrt(3.0)));
    CHECK(within(5, 2) == Approx(1.25 / 2 * 2e-3 / 10)); // two that meet at their greatest speed
    // A pair that is all the way in can come no deeper, whatever its speed.
    near.nearest = 0;
    near.max_speed = near.other_max_speed = 0.4;
    CHECK(limit(near) == Approx(0.8e-3 / std::sqrt(3.0)));
    CHECK_THROWS_AS((ModifiedRepulsionParameters{.speed = -1}.check("Contact")), Error);
    CHECK_THROWS_AS((ModifiedRepulsionParameters{.range = -1}.check("Contact")), Error);
    CHECK_THROWS_WITH((ModifiedRepulsionParameters{.restitution = 1.5}.check("Contact")),
                      imbibe_test::contains("Contact: ModifiedRepulsionParameters::restitution = 1.5"));
    CHECK_NOTHROW(ModifiedRepulsionParameters{}.check("Contact"));
}

TEST_CASE("surface normals point outwards at faces and edges, vanish inside, and deform with the solid") {
    check_normals<2>();
    check_normals<3>();
}

TEST_CASE("the sum of a surface normal counts the volumes that particles have now") {
    const auto a = block<3>(soft(), 1, 0).front();
    auto b = block<3>(soft(), 1, 0, 1, along_x<3>(1.2e-3)).front();
    b.set(density, 800.0);
    const ColumnVector<3> expected = -950 * 1e-9 / 800 * wendland_gradient<3>(along_x<3>(-1.2e-3));
    CHECK((plain(sum(SurfaceNormal<>::Sum{}, a, Cloud<3, Sponge>{b})) - expected).norm() < 1e-12 * expected.norm());
}

TEST_CASE("SurfaceNormalPressure is its equation, equal and opposite") {
    check_surface_pressure<2>();
    check_surface_pressure<3>();
}

TEST_CASE("SurfaceNormalPressure: a face bears pressure times area, and no friction") {
    check_force_on_a_face<2>();
    check_force_on_a_face<3>();
}

TEST_CASE("the new couplings read what they should, where they should") {
    CHECK(sides<ModifiedRepulsion, 2, Water, Sponge>() == "mass velocity | mass velocity");
    CHECK(sides<SurfaceNormalPressure<>::Push, 2, Water, Sponge>() == "mass volume pressure | volume surface_normal");
    CHECK(sides<SurfaceNormalPressure<>::Push, 2, Sponge, Water>() == "mass volume surface_normal | volume pressure");
    CHECK(sides<SurfaceNormal<>::Sum, 3, Sponge>() == "| mass density");
    CHECK(sides<ReferenceSurfaceNormal<>::Sum, 3, Sponge>() == "| mass");
    CHECK(sides<ReferenceSurfaceNormal<>::Turn, 3, Sponge>() == "surface_normal_sum deformation_gradient |");
}

} // namespace interface_forces_test
