// Particles that come, go and change their phase during a run.
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/reference_correction.hpp>
#include <imbibe/solid/total_lagrangian_force.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <map>
#include <vector>

namespace population_test {

namespace sph = imbibe;
using K = sph::WendlandC2;
using imbibe_test::contains;

struct Temperature : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "temperature", unit = "K";
    static constexpr std::string_view rate_name = "temperature_rate", rate_unit = "K/s";
};
inline constexpr Temperature temperature{};
struct Crystals : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "crystals", unit = "";
};
inline constexpr Crystals crystals{};
struct Company : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "company", unit = "";
};
inline constexpr Company company{};

struct Warm {
    using stores = sph::Fields<temperature>;
};
struct Frozen {
    using stores = sph::Fields<temperature, crystals>;
};
/// sum_b m_b W_ab, computed once.
struct CountOnce {
    static constexpr bool once = true;
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<company>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const { return b[sph::mass] * ab.value(K{}); }
};
struct ReadDensity {
    using reads = sph::Fields<sph::density>;
    using sets = sph::Fields<sph::pressure>;
    constexpr auto operator()(const auto& a) const { return a[sph::density] - a.material.density; }
};
struct Water : sph::Fluid<ReadDensity, Warm> {};
struct Ice : sph::Fluid<ReadDensity, Frozen> {};
struct Rubber : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, sph::CompressibleNeoHookean,
                           sph::TotalLagrangianForce<K>> {};
using Freezing = sph::Solver<2, double, sph::SymplecticEuler, Water, Ice, Rubber>;

const std::vector<Freezing::Point> places{{0, 0}, {0.1, 0}, {0.2, 0}, {0, 0.1}, {0.1, 0.1}, {0.2, 0.1}};
const Water water{{.density = 1000, .sound_speed = 10}};
const Ice ice{{.density = 900, .sound_speed = 10}};

TEST_CASE("Particles that are handed over take along the fields that both phases have", "[population]") {
    Freezing scene({.support_radius = 0.25, .time_step = 1e-3});
    const auto liquid = scene.add(water, places, 0.1);
    const auto solid = scene.add(ice, {}, 0.1);
    scene.step();
    for (const std::string& warning : scene.warnings())
        CHECK(warning.find("Ice has no particles") == std::string::npos); // its material is there, on purpose
    std::map<std::uint32_t, double> y;                                    // by what they are called in the water
    for (int i = 0; i < 6; ++i) {
        const auto view = scene[liquid];
        view[temperature](i) = 300 - 20 * view[sph::position](i, 0) / 0.1;
        view[sph::velocity].row(i) << 1 + i, 2;
        view[sph::density](i) = 1010;
        y[view.ids()[static_cast<std::size_t>(i)]] = view[sph::position](i, 1);
    }
    const auto handed =
        scene.hand_over(liquid, solid, [](const auto& view, int i) { return view[temperature](i) < 285; });
    REQUIRE(handed.size() == 4);
    CHECK(scene[liquid].size() == 2);
    CHECK(scene[solid].size() == 4);
    const auto cold = scene[solid];
    for (int i = 0; i < 4; ++i) {
        CHECK(cold[temperature](i) == Approx(300 - 20 * cold[sph::position](i, 0) / 0.1));
        CHECK(cold[sph::velocity](i, 1) == 2);
        CHECK(cold[sph::mass](i) == Approx(10));
        CHECK(cold[sph::density](i) == Approx(909)); // as much above that at rest
        CHECK(cold[crystals](i) == 0);
    }
    for (const auto& one : handed) {
        const auto at = std::find(cold.ids().begin(), cold.ids().end(), one.now) - cold.ids().begin();
        CHECK(cold[sph::position](static_cast<int>(at), 1) == y[one.before]);
    }
    scene.step();
    CHECK(scene[solid][sph::pressure](0) == Approx(9));
    // back again, by position; numbers are new ones
    CHECK(scene.hand_over(solid, liquid, [](const auto& x) { return x[1] > 0.05; }).size() == 2);
    CHECK(scene.hand_over(solid, liquid, [](const auto&) { return false; }).empty());
    scene.step();
    CHECK(scene[liquid].size() == 4);
    CHECK(sph::momentum(scene[liquid])[1] + sph::momentum(scene[solid])[1] == Approx(120));
    CHECK(scene.remove_if(liquid, [](const auto& view, int i) { return view[temperature](i) > 299; }) == 2);
}

TEST_CASE("A phase without material cannot be handed particles", "[population]") {
    Freezing scene({.support_radius = 0.25});
    const auto liquid = scene.add(water, places, 0.1);
    CHECK_THROWS_WITH(scene.hand_over(liquid, sph::PhaseHandle<Ice>{}, [](const auto&) { return true; }),
                      contains("Ice is to get particles of Water and was not given its material") &&
                          contains("scene.add(Ice{{...}}, {}, 0.1)"));
    CHECK(scene[liquid].size() == 6);
}

TEST_CASE("What is computed once is computed anew only where particles came", "[population]") {
    Freezing scene({.support_radius = 0.25, .time_step = 1e-6});
    scene.add(water, places, 0.1);
    std::vector<Freezing::Point> block;
    for (int i = 0; i < 36; ++i)
        block.push_back({5 + 0.1 * (i % 6), 0.1 * (i / 6)});
    const auto rubber = scene.add(Rubber{{.density = 900, .sound_speed = 20, .shear_modulus = 1e4}}, block, 0.1);
    scene.step();
    const auto first = scene[rubber][sph::gradient_correction](0, 0);
    CHECK(first != 0);
    scene[rubber][sph::gradient_correction](0, 0) = 7; // what is computed anew would not stay
    scene.add(water, {{0.3, 0}}, 0.1);
    scene.step();
    CHECK(scene[rubber][sph::gradient_correction](0, 0) == 7);
    std::vector<Freezing::Point> far;
    for (const auto& x : block)
        far.push_back({x[0] + 3, x[1]});
    scene.add(Rubber{{.density = 900, .sound_speed = 20, .shear_modulus = 1e4}}, far, 0.1);
    scene.step();
    CHECK(scene[rubber].size() == 72);
    const auto L = scene[rubber][sph::gradient_correction];
    CHECK(L.col(0).maxCoeff() < 7);
    CHECK(L.col(0).minCoeff() > 0.5);
}

// Sums that are computed once, over one's own and over those of another phase.
struct Left : sph::Fluid<CountOnce> {};
struct Right : sph::Fluid<CountOnce> {};
struct Between : sph::Coupling<Left, Right, sph::Into<Left, CountOnce>> {};

TEST_CASE("A sum that is computed once counts the particles that come to the other phase", "[population]") {
    sph::Solver<2, double, sph::SymplecticEuler, Left, Right, Between> scene(
        {.support_radius = 0.25, .time_step = 1e-6});
    const auto left = scene.add(Left{{.density = 1, .sound_speed = 1}}, {{0, 0}}, 0.1);
    const auto right = scene.add(Right{{.density = 1, .sound_speed = 1}}, {{0.1, 0}}, 0.1);
    scene.step();
    const double m = 0.01, own = m * sph::kernel_value<K, 2>(0.0, 0.25), other = m * sph::kernel_value<K, 2>(0.1, 0.25);
    CHECK(scene[left][company](0) == Approx(own + other));
    CHECK(scene[right][company](0) == Approx(own));
    scene.add(Right{{.density = 1, .sound_speed = 1}}, {{-0.1, 0}}, 0.1);
    scene.step();
    CHECK(scene[left][company](0) == Approx(own + 2 * other));
    scene[right][company](0) = 5;
    scene.add(Left{{.density = 1, .sound_speed = 1}}, {{0, 3}}, 0.1);
    scene.step();
    CHECK(scene[right][company].maxCoeff() == 5); // does not count those on the left
}

} // namespace population_test
