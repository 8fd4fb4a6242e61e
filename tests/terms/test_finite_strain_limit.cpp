// FiniteStrainLimit: how much faster waves are in a strained solid, against second derivatives of the stored energy,
// and the longest step that a strained block bears as a share of the limit, against that of the undeformed one.
#include <catch_shim.hpp>

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/monitor/longest_stable_step.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace sph = imbibe;

namespace finite_strain_test {
namespace {

struct Stuff : sph::Solid<> {};
Stuff rubber(double poisson) {
    const double young = 1e5, rho = 1000;
    return {{.density = rho,
             .sound_speed = sph::sound_speed_of(young, poisson, rho),
             .shear_modulus = sph::shear_modulus_of(young, poisson)}};
}

// As terms compute it, in packs.
template <class Law, int dim>
double stiffening(const Stuff& stuff, const sph::Tensor<double, dim>& F) {
    sph::Tensor<sph::Pack<double, 1>, dim> packed{};
    for (int k = 0; k < dim * dim; ++k)
        packed[k] = F[k];
    return Law::wave_stiffening(stuff, packed)[0];
}

// That of VolumetricDeviatoric where the volume is the same all around; the other laws have theirs.
template <class Law, int dim>
double energy(const auto& material, const sph::Tensor<double, dim>& F) {
    if constexpr (requires { Law::stored_energy(material, F); }) {
        return Law::stored_energy(material, F);
    } else {
        const double J = determinant(F), I1 = trace(transpose(F) * F) + (3 - dim);
        return 0.5 * material.shear_modulus * (std::pow(J, -2.0 / 3) * I1 - 3) +
               0.5 * material.bulk_modulus() * (0.5 * (sph::sq(J) - 1) - std::log(J));
    }
}
// a.Q(N) a of a wave along the stress-free normal N that moves along a, both of length 1: the second derivative of the
// energy, over that of the fastest wave in the stress-free solid.
template <class Law, int dim>
double stiffness_along(const Stuff& stuff, const sph::Tensor<double, dim>& F, const sph::Vector<double, dim>& a,
                       const sph::Vector<double, dim>& N) {
    const double h = 1e-4, rest = stuff.density * sph::sq(stuff.longitudinal_wave_speed());
    const auto at = [&](double step) { return energy<Law, dim>(stuff, F + step * outer(a, N)); };
    return (at(h) - 2 * at(0) + at(-h)) / (h * h) / rest;
}
// The greatest of that in any direction, by climbing from random ones.
template <class Law, int dim>
double fastest_wave(const Stuff& stuff, const sph::Tensor<double, dim>& F) {
    std::mt19937 generator(1);
    std::normal_distribution<double> normal;
    const auto turned = [&](sph::Vector<double, dim> v, double by) {
        for (int d = 0; d < dim; ++d)
            v[d] += by * normal(generator);
        return v / std::sqrt(squared_norm(v));
    };
    double greatest = 0;
    for (int start = 0; start < 8; ++start) {
        auto a = turned({}, 1), N = turned({}, 1);
        double best = stiffness_along<Law, dim>(stuff, F, a, N), by = 0.5;
        for (int k = 0; k < 400; ++k, by *= 0.98) {
            const auto b = turned(a, by), M = turned(N, by);
            if (const double there = stiffness_along<Law, dim>(stuff, F, b, M); there > best)
                best = there, a = b, N = M;
        }
        greatest = std::max(greatest, best);
    }
    return greatest;
}
template <class Law, int dim>
void check_against_energy(double poisson) {
    const Stuff stuff = rubber(poisson);
    CAPTURE(dim, poisson);
    CHECK(stiffening<Law, dim>(stuff, sph::identity<double, dim>()) == Approx(1));
    // along axes the bound is exact
    for (const double stretch : {0.3, 0.6, 1.5, 2.5}) {
        auto F = sph::identity<double, dim>();
        F(0, 0) = stretch;
        CAPTURE(stretch);
        CHECK(stiffening<Law, dim>(stuff, F) == Approx(std::max(fastest_wave<Law, dim>(stuff, F), 0.0)).epsilon(0.25));
        CHECK(stiffening<Law, dim>(stuff, F) > 0.995 * fastest_wave<Law, dim>(stuff, F));
    }
    std::mt19937 generator(2);
    std::uniform_real_distribution<double> any(-0.6, 0.6);
    for (int k = 0; k < 10; ++k) {
        auto F = sph::identity<double, dim>();
        do
            for (int i = 0; i < dim; ++i)
                for (int j = 0; j < dim; ++j)
                    F(i, j) = (i == j ? 1 : 0) + any(generator);
        while (determinant(F) < 0.3);
        const double exact = fastest_wave<Law, dim>(stuff, F), bound = stiffening<Law, dim>(stuff, F);
        CAPTURE(k, exact);
        CHECK(bound > 0.995 * exact);
        CHECK(bound < 2 * exact);
    }
}
template <class Law>
void check_law() {
    for (const double poisson : {0.1, 0.3, 0.45}) {
        check_against_energy<Law, 2>(poisson);
        check_against_energy<Law, 3>(poisson);
    }
}

template <class Law>
struct Block : sph::Solid<sph::ReferenceCorrection<>, sph::DeformationGradient<>, Law, sph::TotalLagrangianForce<>,
                          sph::HourglassControl<>, sph::Clamped> {};

// A square (cube) whose two outer layers are held, stretched to `stretch` of its length each way: the longest step that
// it bears, as a share of the limit of its law.
template <class Law, int dim>
double borne(double poisson, double support, const std::array<double, dim>& stretch) {
    const double spacing = 0.1, length = (dim == 2 ? 14 : 9) * spacing, edge = 2.01 * spacing;
    using Scene = sph::Solver<dim, double, sph::SymplecticEuler, Block<Law>>;
    Scene scene({.support_radius = support * spacing, .threads = 1});
    const Stuff stuff = rubber(poisson);
    const Block<Law> material{
        {.density = stuff.density, .sound_speed = stuff.sound_speed, .shear_modulus = stuff.shear_modulus}};
    const sph::Point<dim> zero = sph::Point<dim>::Zero(), end = sph::Point<dim>::Constant(length);
    const auto block = scene.add(material, sph::fill(sph::Box<dim>{zero, end}, spacing), spacing);
    scene.hold(block, [&](const auto& x) { return x.minCoeff() < edge || (end - x).minCoeff() < edge; });
    auto places = scene[block][sph::position];
    for (int d = 0; d < dim; ++d)
        places.col(d) *= stretch[static_cast<std::size_t>(d)];
    scene.prepare();
    scene.step(1e-9); // then the strains are known
    const auto limits = scene.time_step_limits();
    const auto wave =
        std::find_if(limits.begin(), limits.end(), [](const auto& l) { return l.reason == "elastic wave"; });
    REQUIRE(wave != limits.end());
    return sph::longest_stable_step(scene) / wave->seconds;
}
template <class Law, int dim>
void check_block(double poisson, double support, const std::array<double, dim>& stretch, double least = 0.97) {
    std::array<double, dim> whole;
    whole.fill(1);
    const double at_rest = borne<sph::FiniteStrainLimit<Law>, dim>(poisson, support, whole);
    const double strained = borne<sph::FiniteStrainLimit<Law>, dim>(poisson, support, stretch);
    CAPTURE(dim, poisson, support, stretch[0], stretch[1], at_rest);
    CHECK(at_rest == Approx(borne<Law, dim>(poisson, support, whole)).epsilon(0.03));
    CHECK(strained > least * at_rest);
    CHECK(strained < 1.3 * at_rest);
}

} // namespace
} // namespace finite_strain_test

using namespace finite_strain_test;

TEST_CASE("the fastest wave of a strained solid is that of the second derivatives of its energy, or a little faster") {
    SECTION("neo-Hookean") {
        check_law<sph::CompressibleNeoHookean>();
        check_law<sph::IsochoricNeoHookean>();
    }
    SECTION("St. Venant and Kirchhoff") {
        check_law<sph::StVenantKirchhoff>();
    }
    SECTION("nearly incompressible") {
        check_law<sph::VolumetricDeviatoric<>>();
    }
}

TEST_CASE("a block held at great strains bears the same share of FiniteStrainLimit at any of them") {
    check_block<sph::CompressibleNeoHookean, 2>(0.3, 2.01, {0.35, 0.35});
    check_block<sph::CompressibleNeoHookean, 2>(0.3, 2.01, {0.25, 0.25});
    check_block<sph::CompressibleNeoHookean, 2>(0.45, 1.5, {0.4, 1});
    check_block<sph::CompressibleNeoHookean, 3>(0.3, 2.01, {0.5, 0.5, 0.5});
    check_block<sph::IsochoricNeoHookean, 2>(0.3, 2.01, {0.35, 0.35});
    check_block<sph::IsochoricNeoHookean, 3>(0.3, 2.01, {0.5, 0.5, 0.5});
    check_block<sph::StVenantKirchhoff, 2>(0.3, 2.01, {3, 3});
    check_block<sph::StVenantKirchhoff, 2>(0.45, 1.5, {2, 1});
    // what averages soften is the stiffness of the volume, and of that there is more under strain
    check_block<sph::VolumetricDeviatoric<>, 2>(0.45, 2.01, {0.5, 0.5}, 0.9);
    // without it the law's limit is unsafe there
    CHECK(borne<sph::CompressibleNeoHookean, 2>(0.3, 2.01, {0.25, 0.25}) < 0.75);
    CHECK(borne<sph::StVenantKirchhoff, 2>(0.3, 2.01, {3, 3}) < 0.6);
}
