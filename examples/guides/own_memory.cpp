// A host program that owns its particles: their places are columns of its own memory, which it hands to the neighbour
// search as they are (the search sorts a copy of its own), and the sums over neighbours are its own loop. Here a
// periodic square of points is stirred, and their density summed.
#include <imbibe/imbibe.hpp>

#include <algorithm>
#include <cstdio>
#include <numbers>
#include <vector>

namespace sph = imbibe;

int main() {
    const double dx = 0.02, H = 3 * dx, mass = 1000 * dx * dx, dt = 0.002;
    const auto start = sph::jitter<2>(sph::fill(sph::Box<2>{{0, 0}, {1, 1}}, dx), 0.05 * dx, 1);
    const auto n = static_cast<Eigen::Index>(start.size());
    std::vector<double> memory(2 * start.size()), density(start.size()); // the host's: all x, then all y
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 2>> places(memory.data(), n, 2);
    for (Eigen::Index i = 0; i < n; ++i)
        places.row(i) = start[static_cast<std::size_t>(i)];

    sph::search::NeighbourSearch<2, double> search(H, {.lower = {0, 0}, .length = {1, 1}});
    const int points = search.add(places);
    for (int step = 0; step < 20; ++step) {
        for (Eigen::Index i = 0; i < n; ++i) { // vortices without divergence; the search takes care of the period
            const double x = 2 * std::numbers::pi * places(i, 0), y = 2 * std::numbers::pi * places(i, 1);
            places.row(i) += dt * Eigen::RowVector2d(-std::cos(x) * std::sin(y), std::sin(x) * std::cos(y));
        }
        search.move(points, places);
        search.update();
        for (int i = 0; i < search.size(points); ++i) {
            double sum = sph::kernel_value<sph::WendlandC2, 2>(0.0, H);
            search.for_each(points, i, [&](int, const auto&, double distance) {
                sum += sph::kernel_value<sph::WendlandC2, 2>(distance, H);
            });
            density[static_cast<std::size_t>(i)] = mass * sum;
        }
    }

    // The same sum over all pairs there are, the images next to them included.
    double worst = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        double sum = 0;
        for (Eigen::Index j = 0; j < n; ++j) {
            const Eigen::RowVector2d apart = places.row(i) - places.row(j);
            sum += sph::kernel_value<sph::WendlandC2, 2>((apart - apart.array().round().matrix()).norm(), H);
        }
        worst = std::max(worst, std::abs(mass * sum - density[static_cast<std::size_t>(i)]));
    }
    const auto [least, greatest] = std::minmax_element(density.begin(), density.end());
    std::printf("%d points: density from %.0f to %.0f kg/m^3, off by %.1e kg/m^3 at most\n", search.size(points), *least,
                *greatest, worst);
    return worst < 1e-8 && *least > 900 && *greatest < 1100 ? 0 : 1;
}
