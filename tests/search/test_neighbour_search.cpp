// The neighbour search as other codes use it: by sets and numbers of points, against all pairs.
#include <imbibe/search/neighbour_search.hpp>

#include <catch_shim.hpp>

#include <limits>
#include <random>
#include <set>

namespace neighbour_search_test {

namespace {

using imbibe::search::NeighbourSearch;
using imbibe::search::Periodic;

template <int dim, class Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, dim>;

template <int dim, class Real>
Matrix<dim, Real> random_points(int n, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Matrix<dim, Real> x(n, dim);
    for (int i = 0; i < n; ++i)
        for (int d = 0; d < dim; ++d)
            x(i, d) = static_cast<Real>(uniform(generator));
    return x;
}

/// The points of `b` nearer than `support` to row i of `a`, with the nearest image where sides of length 1 are
/// periodic. Pairs within rounding of the support are left out here and below.
template <int dim, class Real>
std::set<int> all_pairs(const Matrix<dim, Real>& a, int i, const Matrix<dim, Real>& b, double support, bool periodic,
                        bool same) {
    std::set<int> found;
    for (int j = 0; j < b.rows(); ++j) {
        double sum = 0;
        for (int d = 0; d < dim; ++d) {
            double gap = static_cast<double>(a(i, d)) - static_cast<double>(b(j, d));
            if (periodic)
                gap -= std::round(gap);
            sum += gap * gap;
        }
        if (std::sqrt(sum) < support * (1 - 1e-5) && !(same && i == j))
            found.insert(j);
    }
    return found;
}

template <int dim, class Real>
int wrong_points(const NeighbourSearch<dim, Real>& search, int a, const Matrix<dim, Real>& xa, int b,
                 const Matrix<dim, Real>& xb, double support, bool periodic) {
    int wrong = 0;
    for (int i = 0; i < xa.rows(); ++i) {
        std::set<int> found;
        int listed = 0;
        bool measured = true;
        search.for_each(a, i, b, [&](int j, const auto& offset, Real distance) {
            measured = measured && std::abs(offset.norm() - distance) <= Real(1e-6) * distance;
            if (distance < static_cast<Real>(support * (1 - 1e-5))) {
                found.insert(j);
                ++listed;
            }
        });
        wrong += !measured || listed != static_cast<int>(found.size()) ||
                 found != all_pairs<dim, Real>(xa, i, xb, support, periodic, a == b);
    }
    return wrong;
}

template <int dim, class Real>
void check_against_all_pairs(bool periodic) {
    Periodic<dim> sides;
    if (periodic)
        sides.length.fill(1);
    NeighbourSearch<dim, Real> search(0.15, sides);
    auto x = random_points<dim, Real>(400, 1), y = random_points<dim, Real>(150, 2);
    const int first = search.add(x), second = search.add(y);
    search.set_support(first, second, 0.23);
    search.set_support(second, second, 0);
    for (int round = 0; round < 3; ++round) {
        search.update();
        CHECK(wrong_points<dim, Real>(search, first, x, first, x, 0.15, periodic) == 0);
        CHECK(wrong_points<dim, Real>(search, first, x, second, y, 0.23, periodic) == 0);
        CHECK(wrong_points<dim, Real>(search, second, y, first, x, 0.23, periodic) == 0);
        CHECK(search.count(second, 0) == 0);
        x = random_points<dim, Real>(300 + 200 * round,
                                     static_cast<unsigned>(10 + round)); // others, and in other number
        search.move(first, x);
    }
}

} // namespace

TEST_CASE("Neighbours by set and number are those of all pairs", "[search]") {
    for (const bool periodic : {false, true}) {
        check_against_all_pairs<2, float>(periodic);
        check_against_all_pairs<2, double>(periodic);
        check_against_all_pairs<3, float>(periodic);
        check_against_all_pairs<3, double>(periodic);
    }
}

TEST_CASE("Offsets point from the nearest image", "[search]") {
    Periodic<2> sides;
    sides.length[0] = 1;
    NeighbourSearch<2, double> search(0.2, sides);
    Matrix<2, double> x(2, 2);
    x << 0.05, 0.5, 0.95, 0.5;
    const int set = search.add(x);
    search.update();
    REQUIRE(search.count(set, 0) == 1);
    search.for_each(set, 0, [](int j, const auto& offset, double distance) {
        CHECK(j == 1);
        CHECK(offset[0] == Approx(0.1));
        CHECK(offset[1] == 0);
        CHECK(distance == Approx(0.1));
    });
}

TEST_CASE("Coincident points are neighbours, a point is none of its own", "[search]") {
    NeighbourSearch<3, float> search(0.1);
    const int set = search.add(Matrix<3, float>::Constant(50, 3, 0.25f)), empty = search.add(Matrix<3, float>(0, 3));
    search.update();
    CHECK(search.count(set, 7) == 49);
    CHECK(search.count(set, 7, empty) == 0);
    CHECK(search.size(empty) == 0);
}

TEST_CASE("A support of 0 between two sets: nothing is near, and nothing is looked for", "[search]") {
    NeighbourSearch<3, double> search(0.1);
    const int set = search.add(random_points<3, double>(30, 3));
    search.set_support(set, set, 0.2);
    search.set_support(set, set, 0); // the last word counts
    search.update();
    CHECK(search.count(set, 0) == 0);
}

TEST_CASE("Neighbours of points a kilometre apart take no memory between them", "[search]") {
    NeighbourSearch<3, double> search(0.01);
    Matrix<3, double> x(4, 3);
    x << 0, 0, 0, 0.005, 0, 0, 1000, 2000, -1000, 1000.005, 2000, -1000;
    const int set = search.add(x);
    search.update();
    for (int i = 0; i < 4; ++i)
        CHECK(search.count(set, i) == 1);
    x.row(2) << 0, 1e22, 0; // and beyond all measure
    x.row(3) << 0, 1e22, 0;
    search.move(set, x);
    search.update();
    for (int i = 0; i < 4; ++i)
        CHECK(search.count(set, i) == 1);
    x.setConstant(-1e22); // all in one place, so far away that cells cannot be counted from zero
    search.move(set, x);
    search.update();
    for (int i = 0; i < 4; ++i)
        CHECK(search.count(set, i) == 3);
}

TEST_CASE("One point very far away makes cells long, and nobody loses a neighbour", "[search]") {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> place(-5, 5);
    for (const double far : {1e3, 1e8, 1e9, 1e12})
        for (const int axis : {0, 1}) {
            Matrix<2, double> x(400, 2);
            for (int i = 0; i < 400; ++i)
                x.row(i) << place(generator), place(generator);
            x(0, axis) = far;
            NeighbourSearch<2, double> search(1.0);
            const int set = search.add(x);
            search.update();
            for (int i = 0; i < 400; ++i)
                REQUIRE(search.count(set, i) ==
                        ((x.rowwise() - x.row(i)).rowwise().squaredNorm().array() < 1).count() - 1);
        }
}

TEST_CASE("Bad input to the neighbour search is refused by name", "[search]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, -1.0, nan})
        CHECK_THROWS_WITH((NeighbourSearch<2, double>(bad)), imbibe_test::contains("support"));
    Periodic<2> sides;
    sides.length[1] = 0.05;
    CHECK_THROWS_WITH((NeighbourSearch<2, double>(0.1, sides)), imbibe_test::contains("period"));
    sides.length[1] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH((NeighbourSearch<2, double>(0.1, sides)), imbibe_test::contains("period"));

    NeighbourSearch<2, double> search(0.1);
    Matrix<2, double> x = Matrix<2, double>::Zero(3, 2);
    const int set = search.add(x);
    CHECK_THROWS_WITH((NeighbourSearch<2, double>(0.1, {}, 1025)), imbibe_test::contains("threads = 1025"));
    CHECK_THROWS_WITH(search.count(set, 0), imbibe_test::contains("update()"));
    search.update();
    CHECK_THROWS_WITH(search.count(set, 3), imbibe_test::contains("from 0 to 2"));
    CHECK_THROWS_WITH(search.count(1, 0), imbibe_test::contains("set 1"));
    x(2, 1) = nan;
    search.move(set, x);
    CHECK_THROWS_WITH(search.update(), imbibe_test::contains("point 2 of set 0"));
}

} // namespace neighbour_search_test
