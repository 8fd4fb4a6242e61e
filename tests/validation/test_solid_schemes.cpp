// Schemes of the elastic solid that stand beside the usual ones, on scenes with a known outcome: a nearly
// incompressible beam, a twisted column, a plate that swings, and the beam of Turek and Hron under its weight.
#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/kernels/kernels.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/pairwise_shear.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
#include <imbibe/solid/volumetric_deviatoric.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <Eigen/LU>

#include <cases/validation/oscillating_plate.hpp>
#include <cases/validation/turek_hron.hpp>
#include <catch_shim.hpp>
#include <sanitized.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace solid_schemes {

namespace sph = imbibe;
using K = sph::WendlandC2;
using std::numbers::pi;

template <class Law>
struct Elastic : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, Law, sph::TotalLagrangianForce<K>,
                            sph::HourglassControl<K>, sph::CauchyStress, sph::Clamped> {};
struct Pairwise
    : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::PairwiseShearForce<K>, sph::Clamped> {};
struct PairwiseWithViscosity
    : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::PairwiseShearForce<K>,
                 sph::TotalLagrangianViscosity<K>, sph::Clamped> {};
template <int dim, class Law>
using SolidScene = sph::Solver<dim, double, sph::SymplecticEuler, Elastic<Law>>;

// ---- the mean stress of a nearly incompressible beam ----

/// Root mean square of the mean stress less that of its four neighbours on the lattice, and of the mean stress, Pa.
struct MeanStress {
    double alternating = 0, all = 0;
};
template <class View>
MeanStress mean_stress(const View& view, double spacing) {
    std::map<std::pair<int, int>, double> p;
    const auto X = view[sph::reference_position];
    const auto sigma = view[sph::cauchy_stress];
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::mobility](i) > 0)
            p[{static_cast<int>(std::floor(X(i, 0) / spacing)), static_cast<int>(std::floor(X(i, 1) / spacing))}] =
                0.5 * (sigma(i, 0) + sigma(i, 2));
    MeanStress sum;
    int number = 0;
    for (const auto& [at, here] : p) {
        const auto [x, y] = at;
        if (p.count({x - 1, y}) && p.count({x + 1, y}) && p.count({x, y - 1}) && p.count({x, y + 1})) {
            sum.alternating += sph::sq(here - 0.25 * (p[{x - 1, y}] + p[{x + 1, y}] + p[{x, y - 1}] + p[{x, y + 1}]));
            sum.all += sph::sq(here);
            ++number;
        }
    }
    return {std::sqrt(sum.alternating / number), std::sqrt(sum.all / number)};
}

struct Bend {
    MeanStress stress;     // mean over time
    double deflection = 0; // greatest of the tip, m
    double when = 0;       // s
};
/// A cantilever of 0.2 x 0.04 m, E = 2e6 Pa, nu = 0.499, that starts with a transverse velocity growing as (x/L)^2.
template <class Law>
Bend bend(double support_ratio) {
    const double L = 0.2, H = 0.04, spacing = H / 8;
    SolidScene<2, Law> scene({.support_radius = support_ratio * spacing, .threads = 1});
    const auto points = sph::fill(sph::Box<2>{{-3 * spacing, 0}, {L, H}}, spacing);
    const auto beam = scene.add(validation::elastic<Elastic<Law>>(2e6, 0.499, 1000), points, spacing);
    scene.hold(beam, [](const auto& x) { return x[0] < 0; });
    auto view = scene[beam];
    for (int i = 0; i < view.size(); ++i)
        if (view[sph::mobility](i) > 0)
            view[sph::velocity](i, 1) = 1.0 * sph::sq(view[sph::position](i, 0) / L);
    Bend seen{};
    int samples = 0;
    scene.run_until(0.05, [&](const auto& s) {
        const double tip = (view[sph::position] - view[sph::reference_position]).col(1).maxCoeff();
        if (tip > seen.deflection) {
            seen.deflection = tip;
            seen.when = s.time();
        }
        if (s.steps() > 0 && s.steps() % 50 == 0) {
            const MeanStress now = mean_stress(view, spacing);
            seen.stress.alternating += now.alternating;
            seen.stress.all += now.all;
            ++samples;
        }
    });
    seen.stress.alternating /= samples;
    seen.stress.all /= samples;
    return seen;
}

// ---- the twisted column ----

/// How a column of 1 x 1 x 6 m that starts with the angular velocity 105 sin(pi z/12) rad/s twists and comes back.
struct Twist {
    double most = 0, last = 0;        // angle of the top, rad
    double smallest = 1, largest = 1; // volume ratio
    double rough = 0;                 // deviation of a displacement from the mean of its neighbours, spacings
};
template <class Phase>
Twist twist(double poisson, double end, double hourglass = 0.1) {
    const double spacing = 1.0 / 6;
    sph::Solver<3, double, sph::SymplecticEuler, Phase> scene({.support_radius = 2.01 * spacing, .threads = 1});
    const auto points = sph::fill(sph::Box<3>{{-0.5, -0.5, -3 * spacing}, {0.5, 0.5, 6}}, spacing);
    Phase material = validation::elastic<Phase>(1.7e7, poisson, 1100);
    if constexpr (!std::is_same_v<Phase, Pairwise>)
        material.set(sph::HourglassControlParameters{.alpha = hourglass});
    const auto column = scene.add(material, points, spacing);
    scene.hold(column, [](const auto& x) { return x[2] < 0; });
    auto view = scene[column];
    scene.prepare(); // from here on the particles keep their order
    int corner = 0;
    std::map<std::array<int, 3>, int> lattice;
    const auto X = view[sph::reference_position];
    for (int i = 0; i < view.size(); ++i) {
        const double omega = view[sph::mobility](i) * 105 * std::sin(pi * X(i, 2) / 12);
        view[sph::velocity].row(i) << -omega * X(i, 1), omega * X(i, 0), 0;
        if (X(i, 0) + X(i, 1) + X(i, 2) > X(corner, 0) + X(corner, 1) + X(corner, 2))
            corner = i;
        std::array<int, 3> at;
        for (int d = 0; d < 3; ++d)
            at[static_cast<std::size_t>(d)] = static_cast<int>(std::floor(X(i, d) / spacing + 1e-6));
        lattice[at] = i;
    }
    Twist seen;
    double before = std::atan2(X(corner, 1), X(corner, 0));
    scene.run_until(end, [&](const auto& s) {
        const auto x = view[sph::position];
        const double now = std::atan2(x(corner, 1), x(corner, 0));
        seen.last += std::remainder(now - before, 2 * pi);
        before = now;
        seen.most = std::max(seen.most, seen.last);
        if (s.steps() % 100 != 1)
            return;
        const auto F = view[sph::deformation_gradient];
        for (const auto& [at, i] : lattice) {
            Eigen::Matrix3d f;
            for (int k = 0; k < 9; ++k)
                f(k / 3, k % 3) = F(i, k);
            seen.smallest = std::min(seen.smallest, f.determinant());
            seen.largest = std::max(seen.largest, f.determinant());
            Eigen::RowVector3d difference = Eigen::RowVector3d::Zero();
            int found = 0;
            for (std::size_t d = 0; d < 3; ++d)
                for (const int step : {-1, 1}) {
                    auto next = at;
                    next[d] += step;
                    if (const auto j = lattice.find(next); j != lattice.end()) {
                        difference += (x.row(i) - X.row(i)) - (x.row(j->second) - X.row(j->second));
                        ++found;
                    }
                }
            if (found == 6 && at[2] > 2) // not in the kink at the clamp
                seen.rough = std::max(seen.rough, difference.norm() / 6 / spacing);
        }
    });
    return seen;
}

} // namespace solid_schemes

using namespace solid_schemes;

TEST_CASE("Averaged volumes take the checkerboard out of a nearly incompressible beam", "[validation][solid]") {
    const Bend local = bend<sph::CompressibleNeoHookean>(2.01), averaged = bend<sph::VolumetricDeviatoric<>>(2.01);
    CAPTURE(local.stress.alternating, local.stress.all, averaged.stress.alternating, averaged.stress.all);
    CAPTURE(local.deflection, averaged.deflection, local.when, averaged.when);
    CHECK(local.stress.alternating > 0.5 * local.stress.all);
    const Bend isochoric = bend<sph::IsochoricNeoHookean>(2.01); // it is the average that helps, not the split
    CAPTURE(isochoric.stress.alternating, isochoric.stress.all);
    CHECK(isochoric.stress.alternating > 0.5 * isochoric.stress.all);
    CHECK(averaged.stress.alternating < 0.1 * isochoric.stress.alternating);
    CHECK(averaged.stress.alternating < 0.1 * local.stress.alternating);
    CHECK(averaged.deflection == Approx(local.deflection).epsilon(0.1)); // it is the same beam
}

TEST_CASE("A nearly incompressible column twists and comes back whole", "[validation][solid]") {
    if (imbibe_test::left_out("minutes; its law runs in the plane above, others in space below"))
        return;
    // With the hourglass control's usual alpha = 0.1 the displacements are rougher: 0.37 spacings, with
    // CompressibleNeoHookean 0.18.
    const Twist t = twist<Elastic<sph::VolumetricDeviatoric<>>>(0.499, 0.17, 0.3);
    CAPTURE(t.most, t.last, t.smallest, t.largest, t.rough);
    CHECK(t.most > 1.9 * pi);     // about one revolution,
    CHECK(t.last < 0.5 * t.most); // and on its way back
    CHECK(t.smallest > 0.85);
    CHECK(t.largest < 1.15);
    CHECK(t.rough < 0.2); // measured: 0.15
}

TEST_CASE("A column with its shear from pairs has no zero-energy pattern at all", "[validation][solid]") {
    const Twist t = twist<Pairwise>(0.499, 0.17);
    CAPTURE(t.most, t.last, t.smallest, t.largest, t.rough);
    CHECK(t.most > 1.9 * pi);
    CHECK(t.last < 0.5 * t.most);
    CHECK(t.smallest > 0.98);
    CHECK(t.largest < 1.02);
    CHECK(t.rough < 0.05); // a smooth twist of a revolution has 0.03
}

// Without the viscosity it bursts in its first swing.
TEST_CASE("A plate with its shear from pairs and viscosity swings on", "[validation][solid]") {
    if (imbibe_test::left_out("minutes; its terms run in the column above and in tests/terms"))
        return;
    namespace plate = validation::oscillating_plate;
    const auto seen = plate::swing(plate::rubber<PairwiseWithViscosity>(plate::young_modulus),
                                   {.across = 6, .support_ratio = 2, .periods = 5});
    REQUIRE(seen.peaks.size() == 5);
    CAPTURE(seen.peaks.front(), seen.peaks.back(), seen.period());
    CHECK(seen.peaks.back() == Approx(seen.peaks.front()).epsilon(0.005));
    CHECK(seen.period() == Approx(0.2552).epsilon(0.03));
}

// As it is, this beam is too soft by (1 - 1/n^2) in bending with n particles across. With 5 it is also half a spacing
// too short, 0.348 m, because 0.35 m are 87.5 spacings: that hides 2 % of the 4.0 % that are seen. 1.7 % with 10.
TEST_CASE("The beam of Turek and Hron hangs nearly as far as theirs", "[validation][solid]") {
    const sph::Point<2> reference(-7.18777e-3, -66.1029e-3);
    const sph::Point<2> tip = validation::turek_hron::hang(5, 1.4e6);
    CAPTURE(tip[0], tip[1], tip[0] / reference[0] - 1, tip[1] / reference[1] - 1);
    CHECK(std::abs(tip[0] / reference[0] - 1) < 0.09);
    CHECK(std::abs(tip[1] / reference[1] - 1) < 0.045);
}

TEST_CASE("With its bending modulus the beam of Turek and Hron hangs as far as theirs", "[validation][solid]") {
    CHECK(sph::bending_modulus(2, 5) == Approx(2 / 0.96));
    CHECK_THROWS_AS(sph::bending_modulus(2, 1), sph::Error);
    const sph::Point<2> reference(-7.18777e-3, -66.1029e-3);
    for (const int across : {4, 5}) { // 5, in which its length does not fit, is what was asked for
        const sph::Point<2> tip = validation::turek_hron::hang(across, sph::bending_modulus(1.4e6, across));
        CAPTURE(across, tip[0], tip[1], tip[0] / reference[0] - 1, tip[1] / reference[1] - 1);
        CHECK(std::abs(tip[0] / reference[0] - 1) < 0.03);
        CHECK(std::abs(tip[1] / reference[1] - 1) < 0.03);
    }
}
