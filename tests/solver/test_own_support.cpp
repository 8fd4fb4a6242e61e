// A term that says itself how far it reaches sums over its own neighbours, beside terms that reach as far as the
// phases; and the numbers that a term prepares are those of its coefficients and of the lattice.
#include <imbibe/core/lattice.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/solver/costs.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <catch_shim.hpp>

#include <random>
#include <vector>

namespace own_support_test {

namespace sph = imbibe;
using K = sph::WendlandC2;
using imbibe_test::contains;

struct NearSum : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "near_sum", unit = "";
};
inline constexpr NearSum near_sum{};
struct FarSum : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "far_sum", unit = "";
};
inline constexpr FarSum far_sum{};
/// sum_b m_b W_ab over what the phases reach.
struct Near {
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<near_sum>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const { return b[sph::mass] * ab.value(K{}); }
};
struct FarParameters {
    double spacings = 4;
};
/// The same over its own reach, divided by what it is on a lattice of mass 1 per volume, the particle left out.
struct Far {
    using Parameters = FarParameters;
    struct Prepared {
        double on_lattice = 1;
    };
    static double support_radius(const auto& material, const FarParameters& p) { return p.spacings * material.spacing; }
    static double support_radius(const auto& a, const auto& b, const FarParameters& p) {
        return p.spacings * std::max(a.spacing, b.spacing);
    }
    template <int dim>
    static Prepared prepare(const auto&, const sph::Lattice<dim>& lattice) {
        return of(lattice);
    }
    template <int dim>
    static Prepared prepare(const auto&, const auto&, const sph::Lattice<dim>& lattice, const FarParameters&) {
        return of(lattice);
    }
    template <int dim>
    static Prepared of(const sph::Lattice<dim>& lattice) {
        return {lattice.volume() * lattice.sum([](const auto& ab) { return ab.value(K{}); })};
    }
    static double time_step_limit(const auto&, const sph::TimeStepInput& in) { return in.support_radius; }
    static double time_step_limit(const auto&, const auto&, const sph::TimeStepInput& in) { return in.support_radius; }
    static constexpr const char* limit_name = "far";
    Prepared prepared;
    using reads = sph::Fields<sph::mass>;
    using adds = sph::Fields<far_sum>;
    constexpr auto operator()(const auto&, const auto& b, const auto& ab) const {
        using T = std::remove_cvref_t<decltype(b[sph::mass])>;
        return b[sph::mass] * ab.value(K{}) * T(1 / prepared.on_lattice);
    }
};
struct Water : sph::Fluid<Near, Far> {};
struct Oil : sph::Fluid<Near, Far> {};
struct Surface : sph::Coupling<Water, Oil, Near, sph::Into<Water, Far>> {};
template <int dim, class Real>
using Scene = sph::Solver<dim, Real, sph::SymplecticEuler, Water, Oil, Surface>;

/// Two phases at random places of a jittered lattice in a box, whose first `sides` sides are periodic.
template <int dim, class Real>
struct Mixed {
    using Point = Eigen::Matrix<double, dim, 1>;
    static constexpr int across = dim == 2 ? 20 : 12;
    static constexpr double spacing = 1.0 / across;
    sph::Settings<dim> settings;
    std::vector<Point> points[2];
    Scene<dim, Real> scene;

    explicit Mixed(int sides, int threads = 1, double surface = 3.5) : settings(with(sides, threads)), scene(settings) {
        std::mt19937 generator(3);
        std::uniform_real_distribution<double> jitter(-0.3, 0.3);
        for (int i = 0; i < (dim == 2 ? across * across : across * across * across); ++i) {
            const int at[] = {i % across, i / across % across, i / across / across};
            Point x;
            for (int d = 0; d < dim; ++d)
                x[d] = static_cast<Real>(spacing * (at[d] + 0.5 + jitter(generator)));
            points[generator() % 2].push_back(x);
        }
        Water water{{.density = 2, .sound_speed = 1}};
        water.set(FarParameters{.spacings = 5});
        scene.add(water, points[0], spacing);
        scene.add(Oil{{.density = 3, .sound_speed = 1}}, points[1], spacing);
        scene.template coupling<Surface>().set(FarParameters{.spacings = surface});
    }
    static sph::Settings<dim> with(int sides, int threads) {
        sph::Settings<dim> settings{.support_radius = 2 * spacing, .time_step = 1e-9, .threads = threads};
        for (std::size_t d = 0; d < static_cast<std::size_t>(sides); ++d)
            settings.periodic_length[d] = 1;
        return settings;
    }
    /// sum_b m_b W(r_ab; H) of one particle over a phase.
    double sum(const Point& x, int phase, double H) const {
        double all = 0;
        for (const Point& y : points[phase]) {
            Point away = x - y;
            for (int d = 0; d < dim; ++d)
                if (settings.periodic_length[static_cast<std::size_t>(d)] > 0)
                    away[d] -= std::round(away[d]);
            all += sph::kernel_value<K, dim>(away.norm(), H) * (phase == 0 ? 2 : 3) * std::pow(spacing, dim);
        }
        return all;
    }
    static double on_lattice(double H) {
        return std::pow(spacing, dim) * sph::Lattice<dim>{spacing, H}.sum([](const auto& ab) { return ab.value(K{}); });
    }
};

template <int dim, class Real>
void check_sums(int sides, int threads, double tolerance) {
    Mixed<dim, Real> mixed(sides, threads);
    mixed.scene.step();
    const double h = mixed.spacing;
    const auto check = [&](const auto& view, int phase, double own, double surface) {
        double near = 0, far = 0;
        for (int i = 0; i < view.size(); ++i) {
            const auto& x = mixed.points[phase][view.ids()[static_cast<std::size_t>(i)]];
            const double right_near = mixed.sum(x, 0, 2 * h) + mixed.sum(x, 1, 2 * h);
            double right_far = mixed.sum(x, phase, own * h) / mixed.on_lattice(own * h);
            if (surface > 0)
                right_far += mixed.sum(x, 1 - phase, surface * h) / mixed.on_lattice(surface * h);
            near = std::max(near, std::abs(static_cast<double>(view[near_sum][i]) / right_near - 1));
            far = std::max(far, std::abs(static_cast<double>(view[far_sum][i]) / right_far - 1));
        }
        CHECK(near < tolerance);
        CHECK(far < tolerance);
    };
    check(mixed.scene.template get<Water>(), 0, 5, 3.5);
    check(mixed.scene.template get<Oil>(), 1, 4, 0); // Into the water only
}

TEST_CASE("A term that reaches further than the phases sums over its own neighbours, others over theirs", "[sums]") {
    check_sums<2, double>(0, 1, 1e-13);
    check_sums<2, double>(2, 2, 1e-13);
    check_sums<2, float>(1, 1, 1e-5);
    check_sums<3, double>(1, 1, 1e-13);
    check_sums<3, float>(0, 2, 1e-5);
}

TEST_CASE("A term may reach less far than the phases, and its reach may change during a run", "[sums]") {
    Mixed<2, double> mixed(2);
    mixed.scene.step();
    const auto far_of_first = [&] {
        const auto view = mixed.scene.template get<Oil>();
        const int i = static_cast<int>(std::find(view.ids().begin(), view.ids().end(), 0u) - view.ids().begin());
        return view[far_sum][i];
    };
    const double h = mixed.spacing;
    for (const double spacings : {4.0, 1.5, 6.0}) {
        mixed.scene.template get<Oil>().material().set(FarParameters{.spacings = spacings});
        mixed.scene.step();
        CHECK(far_of_first() ==
              Approx(mixed.sum(mixed.points[1][0], 1, spacings * h) / mixed.on_lattice(spacings * h)).epsilon(1e-12));
    }
}

TEST_CASE("describe names the neighbours of a term's own, its limit knows how far it reaches", "[sums]") {
    Mixed<2, double> mixed(2);
    const std::string said = sph::describe(mixed.scene);
    CHECK_THAT(said, contains("of Water (Far, 250 mm) on average; 3 numbers"));
    CHECK_THAT(said, contains("of Oil (Far, 175 mm) on average"));
    double of_water = 0, of_surface = 0;
    for (const sph::TimeStepLimit& limit : mixed.scene.time_step_limits())
        if (std::string(limit.reason) == "far")
            (limit.where == "Water" ? of_water : limit.where == "Surface" ? of_surface : of_water) = limit.seconds;
    CHECK(of_water == Approx(5 * mixed.spacing));
    CHECK(of_surface == Approx(3.5 * mixed.spacing));
    using Costs = sph::Costs<Scene<2, double>>;
    CHECK(Costs::loads<Water, Water> == 2 * (2 + 1)); // place and mass, for each of the two terms
    CHECK(Costs::loads<Oil, Water> == 2 + 1);         // the term that reaches further is in the water only
}

TEST_CASE("A run with a term of its own reach goes on from a checkpoint with the same bits", "[sums]") {
    Mixed<2, float> one(2), two(2);
    one.scene.step();
    const auto file = std::filesystem::temp_directory_path() / "imbibe_own_support.checkpoint";
    sph::write_checkpoint(one.scene, file);
    sph::read_checkpoint(two.scene, file);
    std::filesystem::remove(file);
    for (int k = 0; k < 3; ++k) {
        one.scene.step();
        two.scene.step();
    }
    CHECK(one.scene.template get<Water>()[far_sum] == two.scene.template get<Water>()[far_sum]);
}

TEST_CASE("A term's reach that is no length, or longer than a period, is an error with its name", "[sums]") {
    Mixed<2, double> mixed(2);
    mixed.scene.template coupling<Surface>().set(FarParameters{.spacings = -1});
    CHECK_THROWS_WITH(mixed.scene.step(),
                      contains("Surface, Far: the term reaches -0.05 m; it must reach a finite number above 0 m"));
    mixed.scene.template coupling<Surface>().set(FarParameters{.spacings = 21});
    CHECK_THROWS_WITH(mixed.scene.step(),
                      contains("Surface, Far: support_radius = 1.05 m") && contains("longer than a period of 1 m"));
    mixed.scene.template coupling<Surface>().set(FarParameters{.spacings = 3});
    mixed.scene.step();
}

TEST_CASE("A lattice sums over the neighbours within its support, the particle left out", "[sums]") {
    const auto count = [](const auto& ab) { return ab.distance > 0 ? 1.0 : 0.0; };
    CHECK(sph::Lattice<2>{0.1, 0.11}.sum(count) == 4);
    CHECK(sph::Lattice<2>{0.1, 0.3001}.sum(count) == 28);
    CHECK(sph::Lattice<3>{2, 2.9}.sum(count) == 18);
    // a kernel's integral is nearly one
    const sph::Lattice<3> lattice{0.5, 2};
    CHECK(lattice.volume() == 0.125);
    CHECK(lattice.volume() *
              (lattice.sum([](const auto& ab) { return ab.value(K{}); }) + sph::kernel_value<K, 3>(0.0, 2)) ==
          Approx(1).margin(0.01));
}

/// M_xy = - sum V x y F of a lattice that is turned and then sheared by gamma.
template <int dim>
double sheared_moment(double H, double turned, double gamma) {
    const double cosine = std::cos(turned), sine = std::sin(turned);
    double sum = 0;
    sph::Lattice<dim>{1, H + 1}.sum([&](const auto& ab) {
        const double y = cosine * ab.offset[1] - sine * ab.offset[0],
                     x = cosine * ab.offset[0] + sine * ab.offset[1] + gamma * y,
                     r = std::sqrt(x * x + y * y + (dim == 3 ? sph::sq(ab.offset[dim - 1]) : 0));
        if (r < H) {
            const auto offset = sph::Vector<double, dim>::filled(r / std::sqrt(dim));
            sum -= x * y * sph::Pair<dim, double>(offset, r, sph::SupportRadius(H), {}).gradient(K{});
        }
        return 0.0;
    });
    return sum;
}
template <int dim>
void check_stiffness(double H) {
    const double d = 1e-5, quarter = std::atan(1);
    const auto stiffness = [&](double turned) {
        return -(sheared_moment<dim>(H, turned, d) - sheared_moment<dim>(H, turned, -d)) / (2 * d);
    };
    const double axes = stiffness(0), diagonals = stiffness(quarter);
    const double greatest = std::abs(axes) > std::abs(diagonals) ? axes : diagonals;
    CAPTURE(dim, H, axes, diagonals);
    CHECK((sph::Lattice<dim>{1e-3, H * 1e-3}.template shear_stiffness<K>()) == Approx(greatest).epsilon(1e-5));
}

TEST_CASE("A lattice under pressure resists shear as the slope of its sheared moments says", "[sums]") {
    for (const double H : {2.2, 2.6, 3.0, 4.0}) {
        check_stiffness<2>(H);
        check_stiffness<3>(H);
    }
    CHECK(sph::Lattice<2>{1, 2.2}.shear_stiffness<K>() == Approx(-0.0396).epsilon(0.002));
}

} // namespace own_support_test
