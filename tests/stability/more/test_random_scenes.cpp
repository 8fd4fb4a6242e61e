// Random scenes with fixed seeds: each either runs 200 steps with all its indicators in bounds, or is refused at the
// start with a reason. In the plane and in space, in double and in float, of three compositions.
#include <catch_shim.hpp>

#include <cases/stability/coupled.hpp>

#include <limits>
#include <optional>
#include <random>

namespace {

using namespace stability;

/// Numbers that are the same everywhere.
class Dice {
public:
    explicit Dice(unsigned seed) : generator_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(generator_()) / 4294967295.0;
    }
    double evenly_in_logarithm(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    bool once_in(int times) { return generator_() % static_cast<unsigned>(times) == 0; }

private:
    std::mt19937 generator_;
};

/// A number that no scene should take.
double nonsense(Dice& dice) {
    const double all[] = {-1, 0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    return all[static_cast<std::size_t>(dice.between(0, 3.999))];
}

struct Tried {
    int ran = 0, refused = 0;
};

/// Draws a scene of composition C: water in a tank with a block of rubber that falls into it, or only one of them.
/// @param supports between which the support radius is drawn, in spacings
template <class C, class Real, int dim>
void try_one(unsigned seed, const std::array<double, 2>& supports, Tried& tried) {
    using Fluid = typename C::Fluid;
    Dice dice(seed);
    const double spacing = dice.evenly_in_logarithm(1e-4, 10), support = dice.between(supports[0], supports[1]);
    double water_density = dice.evenly_in_logarithm(1, 1e4),
           body_density = water_density * dice.evenly_in_logarithm(0.3, 10);
    const double gravity = dice.evenly_in_logarithm(0.1, 100), depth = 8 * spacing;
    double c = dice.between(10, 40) * std::sqrt(2 * gravity * 2 * depth);
    const double poisson = dice.between(-0.2, 0.49), E = body_density * sph::sq(c * dice.between(0.3, 2));
    double given_spacing = spacing, given_support = support * spacing,
           viscosity = 0.01 * water_density * c * spacing * dice.between(0, 1);
    const bool has_water = !dice.once_in(4), has_body = !has_water || dice.once_in(2), spoilt = dice.once_in(4);
    const bool overlapping = spoilt && dice.once_in(6);
    bool must_be_refused = overlapping;
    if (spoilt && !overlapping) {
        // A number of a phase that is not in the scene may be what it likes.
        struct Number {
            double* number;
            bool used;
        };
        const Number numbers[] = {{&water_density, has_water},
                                  {&body_density, has_body},
                                  {&c, has_water},
                                  {&given_spacing, true},
                                  {&given_support, true}};
        const Number& chosen = numbers[static_cast<std::size_t>(dice.between(0, 4.999))];
        *chosen.number = nonsense(dice);
        must_be_refused = chosen.used;
    }
    const double share = dice.once_in(2) ? 0.5 : 1; // of the water's spacing and support: those of the body
    CAPTURE(seed, spacing, support, share, water_density, body_density, gravity, c, poisson, E, viscosity, has_water,
            has_body, spoilt, overlapping);
    using Scene = CoupledScene<C, Real, dim>;
    bool started = false;
    try {
        Scene scene({.gravity = downwards<dim>(gravity), .support_radius = given_support, .threads = 1});
        std::optional<sph::PhaseHandle<typename Fluid::Water>> pool;
        std::optional<sph::PhaseHandle<typename C::Body>> block;
        std::optional<Roughness> rough;
        const double off = C::gap * spacing, wide = (dim == 2 ? 10 : 8) * spacing, inner = wide + 4 * spacing + 2 * off;
        if (has_water) {
            typename Fluid::Water water{{.density = water_density, .sound_speed = c, .viscosity = viscosity}};
            Fluid::set(water);
            C::set(scene.template coupling<typename C::Contact>(), water);
            Fluid::set(scene.template coupling<typename Fluid::Sides>(), water);
            auto points = sph::fill(box<dim>({off, off}, {off + wide, off + depth}), spacing);
            if (overlapping)
                points.push_back(points.front());
            pool = scene.add(water, points, given_spacing);
            typename Fluid::Tank tank{{.density = water_density}};
            tank.sound_speed = c;
            const auto inside = box<dim>({0, 0}, {inner, 20 * spacing});
            scene.add(tank, sph::tank(inside, spacing, 4, sph::Sides::y_high), spacing);
        }
        if (has_body) {
            auto body = elastic<typename C::Body>(E, poisson, body_density);
            C::set(body);
            body.support_radius = share * given_support;
            const double foot = depth + spacing + 2 * off;
            auto points = sph::fill(box<dim>({2 * spacing, foot}, {7 * spacing, foot + 4 * spacing}), share * spacing);
            if (overlapping)
                points.push_back(points.front());
            block = scene.add(body, points, share * given_spacing);
            rough.emplace(points, share * given_spacing);
            scene[*block][sph::velocity].col(1).setConstant(static_cast<Real>(-std::sqrt(gravity * depth)));
        }
        scene.prepare();
        started = true;
        sph::Guard<dim> guard({.interval = 1});
        guard(scene);
        for (int k = 0; k < 107; ++k) { // later the body hits the water, or the floor, whatever the steps are
            scene.step();
            guard(scene);
        }
        if (pool) {
            CHECK(closest_pair(scene[*pool]) > 0.2);
            CHECK(way_into_wall(scene[*pool], inner) < 0.5);
        }
        if (block) { // 0.006 and 0.99 at worst
            CHECK((*rough)(scene[*block]) < 0.05);
            CHECK(closest_pair(scene[*block]) > 0.9);
        }
        CHECK(!must_be_refused);
        ++tried.ran;
    } catch (const sph::Error& error) {
        INFO(error.what());
        CHECK(!started);
        CHECK(must_be_refused);
        CHECK(std::string(error.what()).size() > 20);
        CHECK_THAT(error.what(), imbibe_test::contains("must") || imbibe_test::contains("nearer"));
        ++tried.refused;
    }
}

template <class C, class Real = double, int dim = 2>
void try_all(unsigned last_seed, const std::array<double, 2>& supports) {
    Tried tried;
    for (unsigned seed = 1; seed <= last_seed; ++seed)
        try_one<C, Real, dim>(seed, supports, tried);
    CHECK(tried.ran >= static_cast<int>(last_seed / 2));
    CHECK(tried.refused >= static_cast<int>(last_seed / 10));
}

} // namespace

TEST_CASE("Random scenes run or are refused with a reason", "[stability]") {
    try_all<SoundCoupling>(60, {1.8, 3.5});
    try_all<RiemannCoupling>(30, {2.6, 3.5});
    try_all<PaperCoupling>(30, {1.25, 1.25});
}

TEST_CASE("Random scenes in space run or are refused with a reason", "[stability]") {
    try_all<SoundCoupling, float, 3>(30, {2, 3});
}
