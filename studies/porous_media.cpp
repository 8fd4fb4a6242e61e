// permeability() beside a lattice-Boltzmann method on the same porous bodies: values, errors and what both cost.
//
//   build-benchmark/studies/porous_media                             spheres, a gyroid and a felt of fibres
//   build-benchmark/studies/porous_media --raw berea_pore.raw --voxels 110 --from 0 0 0 --size 60
//
// The second takes a cube out of an image of 110^3 bytes, 0 where it is pore. Both methods have the same periodic cell.
// Lattice-Boltzmann is run with voxels of half a spacing and of a third of one, and extrapolated in proportion to
// their side, as its walls are stairs.
#include "lattice_boltzmann.hpp"

#include <imbibe/geometry/image.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/geometry/triply_periodic.hpp>
#include <imbibe/input/read_image.hpp>
#include <imbibe/porous/permeability.hpp>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <random>

namespace sph = imbibe;

namespace {

/// A felt: straight fibres through a cell of side 1, each at random, with all its images.
struct Felt {
    double radius = 0;
    std::vector<std::pair<sph::Point<3>, sph::Point<3>>> fibres; ///< a point and a direction

    [[nodiscard]] bool contains(const sph::Point<3>& x) const {
        return bounds().contains(x) && std::any_of(fibres.begin(), fibres.end(), [&](const auto& fibre) {
                   const sph::Point<3> from = x - fibre.first;
                   return (from - from.dot(fibre.second) * fibre.second).norm() < radius;
               });
    }
    [[nodiscard]] sph::Box<3> bounds() const { return {{0, 0, 0}, {1, 1, 1}}; }
};

Felt felt(int number, double radius) {
    std::mt19937_64 random(1);
    const auto even = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Felt result{radius, {}};
    for (int k = 0; k < number; ++k) {
        sph::Point<3> direction(even() - 0.5, even() - 0.5, 0.3 * (even() - 0.5));
        direction.normalize();
        result.fibres.emplace_back(sph::Point<3>(even(), even(), even()), direction);
    }
    return result;
}

/// A sphere in the middle of a cell of side 1.
struct BallInCell {
    sph::Sphere<3> ball;
    [[nodiscard]] bool contains(const sph::Point<3>& x) const { return ball.contains(x) && bounds().contains(x); }
    [[nodiscard]] sph::Box<3> bounds() const { return {{0, 0, 0}, {1, 1, 1}}; }
};

template <class Shape>
study::Voxelised voxelise(const Shape& shape, double side) {
    const sph::Box<3> cell = shape.bounds();
    study::Voxelised image;
    for (int k = 0; k < 3; ++k)
        image.size[static_cast<std::size_t>(k)] = static_cast<int>(std::lround(cell.size()[k] / side));
    for (int z = 0; z < image.size[2]; ++z)
        for (int y = 0; y < image.size[1]; ++y)
            for (int x = 0; x < image.size[0]; ++x)
                image.open.push_back(!shape.contains(cell.lower() + side * sph::Point<3>(x + 0.5, y + 0.5, z + 0.5)));
    return image;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The row of one body. @param unit of length of k, m
template <class Shape>
std::string row(const std::string& name, const Shape& shape, double spacing, double unit) {
    const auto begin = std::chrono::steady_clock::now();
    const auto particles = sph::permeability(shape, spacing, 0);
    const double ours = seconds_since(begin);
    const auto then = std::chrono::steady_clock::now();
    const auto coarse = study::lattice_boltzmann(voxelise(shape, spacing / 2), 0);
    const auto fine = study::lattice_boltzmann(voxelise(shape, spacing / 3), 0);
    const double theirs = seconds_since(then), k_coarse = coarse.permeability * sph::sq(spacing / 2),
                 k_fine = fine.permeability * sph::sq(spacing / 3), k = 3 * k_fine - 2 * k_coarse;
    char line[300];
    std::snprintf(line, sizeof line, "| %s | %.3f | %.4g | %.4g | %.1f | %.4g +- %.2g | %.1f | %+.1f %% |\n",
                  name.c_str(), particles.porosity, k_fine / sph::sq(unit), k / sph::sq(unit), theirs,
                  particles.column[0] / sph::sq(unit), particles.error / sph::sq(unit), ours,
                  100 * (particles.column[0] / k - 1));
    std::printf("%s", line);
    std::fflush(stdout);
    return line;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Permeability by particles and by a lattice-Boltzmann method."};
    std::string file;
    int voxels = 110, size = 60, per_spacing = 2;
    std::vector<int> from{0, 0, 0};
    app.add_option("--raw", file, "an image of voxels^3 bytes, 0 where it is pore");
    app.add_option("--voxels", voxels, "voxels along its sides")->check(CLI::Range(8, 4096));
    app.add_option("--from", from, "first voxel of the cube that is taken")->expected(3);
    app.add_option("--size", size, "voxels along the cube; a multiple of --voxels-per-spacing")
        ->check(CLI::Range(8, 4096));
    app.add_option("--voxels-per-spacing", per_spacing, "how fine the particles are")->check(CLI::Range(1, 16));
    CLI11_PARSE(app, argc, argv);
    try {
        std::printf("| body | porosity | k, voxels of 1/3 spacing | extrapolated | s | k, particles | s | apart |\n"
                    "|---|---|---|---|---|---|---|---|\n");
        if (!file.empty()) {
            const auto whole = sph::read_raw(file, {voxels, voxels, voxels}, sph::SampleType::uint8, sph::Fastest::x);
            const auto part =
                sph::crop(whole, {from[0], from[1], from[2]}, {from[0] + size, from[1] + size, from[2] + size});
            const sph::ImageBody body(part, {.sides = sph::Point<3>::Ones(),
                                             .threshold = 0.5,
                                             .solid = sph::SolidIs::above,
                                             .beyond = sph::Beyond::repeated});
            row(sph::text(file.substr(file.find_last_of('/') + 1), " from ", from[0], " ", from[1], " ", from[2], ", ",
                          size, "^3 voxels, voxel^2"),
                body, per_spacing, 1);
            return 0;
        }
        const double radius = std::cbrt(3 * 0.343 / (4 * 3.14159265358979));
        row("spheres, solid 0.343, 24 across, L^2", BallInCell{sph::Sphere<3>{{0.5, 0.5, 0.5}, radius}}, 1.0 / 24, 1);
        row("gyroid, solid 0.4, 24 across, L^2", sph::gyroid({{0, 0, 0}, {1, 1, 1}}, 1, 0.4), 1.0 / 24, 1);
        row("felt of 8 fibres, 5 spacings thick, 32 across, L^2", felt(8, 2.5 / 32), 1.0 / 32, 1);
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "porous_media: %s\n", error.what());
        return 2;
    }
}
