// What terms reduce over the particles of a phase: sums that a program and a guard ask for, and extremes that limits on
// the step depend on.
#include <imbibe/monitor/energy.hpp>
#include <imbibe/monitor/guard.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <cmath>
#include <vector>

namespace reductions_test {

namespace sph = imbibe;
using imbibe_test::contains;

struct Charge : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "charge", unit = "C";
    static constexpr bool given = true;
};
inline constexpr Charge charge{};

struct SpringParameters {
    double stiffness = 2; // N/m
};
/// A spring from every particle to the origin, whose energy is its own business, and a limit by the greatest charge.
struct Spring {
    using Parameters = SpringParameters;
    using stores = sph::Fields<charge>;
    struct Pull {
        using reads = sph::Fields<sph::mass, sph::position>;
        using adds = sph::Fields<sph::acceleration>;
        Parameters parameters{};
        constexpr auto operator()(const auto& a) const {
            return (-parameters.stiffness / a[sph::mass]) * a[sph::position];
        }
    };
    using parts = sph::Parts<Pull>;
    struct Energy {
        using reads = sph::Fields<sph::position>;
        using reduces = sph::Sum<sph::StoredEnergy>;
        Parameters parameters{};
        double operator()(const auto& a) const {
            return 0.5 * parameters.stiffness * sph::squared_norm(a[sph::position]);
        }
    };
    struct Greatest {
        using reads = sph::Fields<charge>;
        using reduces = sph::Max<Charge>;
        double operator()(const auto& a) const { return a[charge]; }
    };
    struct Least {
        using reads = sph::Fields<charge>;
        using reduces = sph::Min<Charge>;
        double operator()(const auto& a) const { return a[charge] > 100 ? 100 : a[charge]; } // it may branch
    };
    struct Total {
        using reads = sph::Fields<charge>;
        using reduces = sph::Sum<Charge>;
        double operator()(const auto& a) const { return a[charge] / a.material.density; }
    };
    using reductions = sph::Parts<Energy, Greatest, Least, Total>;

    static constexpr const char* limit_name = "charge";
    static double time_step_limit(const auto&, const sph::TimeStepInput& in) { return in.greatest + 10 * in.least; }
};
struct Dust : sph::Fluid<Spring> {};
template <int dim, class Real>
using Scene = sph::Solver<dim, Real, sph::SymplecticEuler, Dust>;

TEST_CASE("A term's own reductions are those of a loop over all particles", "[reductions]") {
    std::vector<Scene<2, float>::Point> points;
    for (int i = 0; i < 9000; ++i) // more than one block
        points.push_back({0.01 * (i % 100), 0.01 * (i / 100)});
    std::vector<double> first;
    for (const int threads : {1, 2}) {
        Scene<2, float> scene({.support_radius = 0.02, .time_step = 1e-6, .threads = threads});
        Dust dust{{.density = 4, .sound_speed = 10}};
        dust.set(SpringParameters{.stiffness = 3});
        const auto handle = scene.add(dust, points, 0.01);
        double energy = 0, total = 0;
        for (int i = 0; i < 9000; ++i) {
            scene[handle][charge](i) = static_cast<float>(200 * std::sin(i) * std::sin(i) + 7);
            energy += 1.5 * scene[handle][sph::position].row(i).cast<double>().squaredNorm();
            total += static_cast<double>(scene[handle][charge](i)) / 4;
        }
        const auto view = scene[handle];
        const double greatest = view[charge].maxCoeff(), least = view[charge].minCoeff();
        CHECK(sph::stored_energy(view) == Approx(energy).epsilon(1e-12));
        CHECK(sph::reduced<sph::Sum<sph::StoredEnergy>>(view) == sph::stored_energy(view));
        CHECK(sph::reduced<sph::Sum<Charge>>(view) == Approx(total).epsilon(1e-12));
        CHECK(sph::reduced<sph::Max<Charge>>(view) == greatest);
        CHECK(sph::reduced<sph::Min<Charge>>(view) == least);
        CHECK(sph::reduced<sph::Max<sph::StoredEnergy>>(view) == -std::numeric_limits<double>::infinity()); // none
        scene.prepare();
        const auto limits = scene.time_step_limits();
        REQUIRE(limits.size() > 0);
        const auto of_charge = std::find_if(limits.begin(), limits.end(), [](const sph::TimeStepLimit& limit) {
            return std::string(limit.reason) == "charge";
        });
        REQUIRE(of_charge != limits.end());
        CHECK(of_charge->seconds == greatest + 10 * least);
        // the scene's own sums, by threads, have the same bits for any number of them
        for (const auto& row : scene.scene_engine().reductions)
            first.push_back(sph::detail::reduced(scene.scene_engine().phase(row.phase), row, threads));
    }
    REQUIRE(first.size() == 8);
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(first[k] == first[k + 4]);
}

TEST_CASE("A guard counts the energy that a term of one's own says that it stores", "[reductions]") {
    // Released springs turn what they have stored into motion. A guard that did not know of it would end the run.
    Scene<2, double> scene({.support_radius = 0.2, .time_step = 1e-3});
    std::vector<Scene<2, double>::Point> points;
    for (int i = 0; i < 20; ++i)
        points.push_back({1 + 0.1 * i, 0.5});
    Dust dust{{.density = 100, .sound_speed = 100}};
    const auto handle = scene.add(dust, points, 0.1);
    const double before = sph::stored_energy(scene[handle]) + sph::kinetic_energy(scene[handle]);
    sph::Guard<2> guard({.interval = 1});
    scene.run_until(0.5, guard);
    const double kinetic = sph::kinetic_energy(scene[handle]);
    CHECK(kinetic > 0.1 * before);
    CHECK(sph::stored_energy(scene[handle]) + kinetic == Approx(before).epsilon(1e-2));
    // Motion that comes from nowhere does.
    auto v = scene[handle][sph::velocity];
    v *= 3;
    CHECK_THROWS_WITH(scene.run_until(0.6, guard), contains("energy has grown by"));
}

} // namespace reductions_test
