// Lists of neighbours that never change: runs and stencils against all pairs, on lattices and off them.
#include "brute_force.hpp"

#include <imbibe/search/stencils.hpp>

#include <catch_shim.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace stencils_test {

namespace {

using namespace search_test;

template <int dim_, class Real_>
struct Case {
    static constexpr int dim = dim_;
    using Real = Real_;
    static constexpr int width = imbibe::native_width<Real>;
};

// What the lists of some points are, with the points in their order.
template <class C>
struct Made {
    Cloud<C::dim, typename C::Real> cloud;
    imbibe::search::FixedLists lists;
    int packs = 0;       ///< with a stencil
    int wrong_runs = 0;  ///< particles
    int wrong_pairs = 0; ///< pairs in packs that are missing, or there twice
    int beyond = 0;      ///< entries that reach beyond the points

    Made(Cloud<C::dim, typename C::Real> points, double support, double spacing, const Periodic<C::dim>& periodic = {},
         int threads = 1)
        : cloud(std::move(points)),
          lists(imbibe::search::find_fixed_lists<C::width>(cloud.points(), support, spacing, periodic, threads)) {
        cloud.reorder(lists.order);
        Comparison<C::width, C::dim, typename C::Real> runs{support, periodic};
        runs.compare(cloud, cloud, lists.runs);
        wrong_runs = runs.wrong + runs.twice;
        for (int first = 0; first < cloud.n; first += C::width)
            if (const auto stencil = lists.stencils[first / C::width]; !stencil.is_empty()) {
                ++packs;
                compare(first, stencil, support, periodic);
            }
    }

private:
    void compare(int first, const imbibe::search::RunList::Range& stencil, double support,
                 const Periodic<C::dim>& periodic) {
        const auto n = static_cast<std::size_t>(cloud.n), lanes = static_cast<std::size_t>(C::width);
        constexpr auto images = static_cast<std::size_t>(imbibe::search::image_count<C::dim>);
        std::vector<int> times(images * lanes * n); // that lane and j are a pair through an image
        stencil.for_each([&](Run run, int image) {
            for (std::size_t lane = 0; lane < lanes; ++lane)
                if (run.first() + lane >= n || run.count() != lanes)
                    ++beyond;
                else
                    ++times[(static_cast<std::size_t>(image) * lanes + lane) * n + run.first() + lane];
        });
        for (std::size_t image = 0; image < images; ++image)
            for (std::size_t lane = 0; lane < lanes; ++lane)
                for (std::size_t j = 0; j < n; ++j) {
                    double distance2 = 0;
                    bool seen = true; // through sides that are periodic alone
                    for (int d = 0; d < C::dim; ++d) {
                        const double length = periodic.length[static_cast<std::size_t>(d)];
                        const int step = imbibe::search::image_step(static_cast<int>(image), d);
                        seen = seen && (step == 0 || length > 0);
                        const double gap = cloud.at(first + static_cast<int>(lane), d) - step * length -
                                           cloud.at(static_cast<int>(j), d);
                        distance2 += gap * gap;
                    }
                    if (seen && std::sqrt(distance2) < support * (1 - 1e-4))
                        wrong_pairs += times[(image * lanes + lane) * n + j] != 1;
                }
    }
};

template <class C>
void shuffle(Cloud<C::dim, typename C::Real>& cloud, unsigned seed) {
    std::vector<std::uint32_t> order(static_cast<std::size_t>(cloud.n));
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    cloud.points(); // makes room
    cloud.reorder(order);
}

template <class C>
Cloud<C::dim, typename C::Real> block(int sides) {
    return lattice<C::dim, typename C::Real>(sides, 0.1, 0.3);
}
// Without what is in a ball around its middle, so that rows have all lengths.
template <class C>
Cloud<C::dim, typename C::Real> hollow(int sides) {
    const auto full = block<C>(sides);
    const double middle = 0.3 + 0.05 * (sides - 1);
    Cloud<C::dim, typename C::Real> cloud;
    for (int i = 0; i < full.n; ++i) {
        std::array<double, static_cast<std::size_t>(C::dim)> x;
        double distance2 = 0;
        for (int d = 0; d < C::dim; ++d) {
            x[static_cast<std::size_t>(d)] = full.at(i, d);
            distance2 += std::pow(full.at(i, d) - middle, 2);
        }
        if (distance2 > std::pow(0.03 * sides, 2))
            cloud.add(x);
    }
    return cloud;
}

} // namespace

#define LATTICE_CASES (Case<2, float>), (Case<2, double>), (Case<3, float>), (Case<3, double>)

TEMPLATE_TEST_CASE("Stencils have every pair once, and take fewer packs on a lattice", "[search][stencils]",
                   LATTICE_CASES) {
    for (const double supports : {2.0, 2.6}) {
        auto cloud = block<TestType>(TestType::dim == 2 ? 25 : 11);
        shuffle<TestType>(cloud, 3);
        const Made<TestType> made(cloud, 0.1 * supports, 0.1);
        CHECK(made.wrong_runs == 0);
        CHECK(made.wrong_pairs == 0);
        CHECK(made.beyond == 0);
        if (TestType::width > 1)
            CHECK(made.packs > 3 * made.cloud.n / (4 * TestType::width));
    }
}

TEMPLATE_TEST_CASE("Stencils have every pair once where rows have different lengths", "[search][stencils]",
                   LATTICE_CASES) {
    const Made<TestType> made(hollow<TestType>(TestType::dim == 2 ? 25 : 12), 0.26, 0.1);
    CHECK(made.wrong_runs == 0);
    CHECK(made.wrong_pairs == 0);
    CHECK(made.beyond == 0);
}

TEMPLATE_TEST_CASE("Points off a lattice have runs, but for a few packs", "[search][stencils]", LATTICE_CASES) {
    const Made<TestType> made(random_cloud<TestType::dim, typename TestType::Real>(700, 0.0, 1.0, 5), 0.17, 0.1);
    CHECK(made.wrong_runs == 0);
    CHECK(made.wrong_pairs == 0);
    CHECK(made.packs < 700 / TestType::width / 8 + 1);
}

TEMPLATE_TEST_CASE("Stencils have pairs through periodic sides once", "[search][stencils]", LATTICE_CASES) {
    const int sides = TestType::dim == 2 ? 24 : 10;
    Periodic<TestType::dim> periodic;
    periodic.lower[0] = 0.25;
    periodic.length[0] = 0.1 * sides;
    const Made<TestType> made(block<TestType>(sides), 0.26, 0.1, periodic);
    CHECK(made.wrong_runs == 0);
    CHECK(made.wrong_pairs == 0);
    CHECK(made.beyond == 0);
    if (TestType::width > 1)
        CHECK(made.packs > 0);
}

TEMPLATE_TEST_CASE("Fixed lists depend neither on the given order nor on the number of threads", "[search][stencils]",
                   LATTICE_CASES) {
    auto cloud = hollow<TestType>(TestType::dim == 2 ? 60 : 16);
    const Made<TestType> one(cloud, 0.2, 0.1);
    shuffle<TestType>(cloud, 7);
    const Made<TestType> other(cloud, 0.2, 0.1, {}, 2);
    CHECK(one.cloud.x == other.cloud.x);
    CHECK(one.packs == other.packs);
    bool same = true;
    for (int i = 0; i < one.cloud.n; ++i) {
        const auto mine = one.lists.runs[i], others = other.lists.runs[i];
        same = same && std::equal(mine.begin(), mine.end(), others.begin(), others.end());
    }
    for (int k = 0; k < one.cloud.n / TestType::width; ++k) {
        const auto mine = one.lists.stencils[k], others = other.lists.stencils[k];
        same = same && std::equal(mine.begin(), mine.end(), others.begin(), others.end());
    }
    CHECK(same);
}

TEST_CASE("No point at all has no lists", "[search][stencils]") {
    using C = Case<3, double>;
    const Made<C> made({}, 0.2, 0.1);
    CHECK(made.lists.order.empty());
    CHECK(made.lists.runs.size() == 0);
}

} // namespace stencils_test
