// Slow flow through the pores of an image by a lattice-Boltzmann method: the reference that permeability() is held to.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace study {

/// A periodic block of voxels, x fastest.
struct Voxelised {
    std::array<int, 3> size;        ///< voxels along x, y, z
    std::vector<std::uint8_t> open; ///< 1: pore, 0: solid; size[0]*size[1]*size[2]
};

/// What lattice_boltzmann() found.
struct LatticeBoltzmannFlow {
    double permeability = 0; ///< along the axis, in squares of a voxel's side
    double porosity = 0;     ///< open voxels over all
    int steps = 0;           ///< time steps
};

/// Permeability along `axis`: 19 velocities, two relaxation times with the magic number 3/16 (walls lie half way
/// between voxels, whatever the viscosity), a body force, periodic sides. Until the extrapolation of the mean velocity
/// in time (Aitken) adds less than `left` of it, or 100 000 steps.
///
/// Source: Ginzburg, Verhaeghe and d'Humieres (2008), two relaxation times; Guo, Zheng and Shi (2002), the force.
inline LatticeBoltzmannFlow lattice_boltzmann(const Voxelised& image, int axis, double left = 2e-3) {
    constexpr int n = 19;
    static constexpr int velocity[n][3] = {{0, 0, 0},  {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},   {0, -1, 0},
                                           {0, 0, 1},  {0, 0, -1},  {1, 1, 0},   {-1, -1, 0}, {1, -1, 0},
                                           {-1, 1, 0}, {1, 0, 1},   {-1, 0, -1}, {1, 0, -1},  {-1, 0, 1},
                                           {0, 1, 1},  {0, -1, -1}, {0, 1, -1},  {0, -1, 1}};
    const auto opposite = [](int q) { return q == 0 ? 0 : (q - 1) / 2 * 2 + (q % 2 == 1 ? 2 : 1); };
    float weight[n];
    for (int q = 0; q < n; ++q)
        weight[q] = q == 0 ? 1.0f / 3 : q < 7 ? 1.0f / 18 : 1.0f / 36;

    const auto [X, Y, Z] = image.size;
    std::vector<int> cell_of(image.open.size(), -1), voxel_of;
    for (std::size_t i = 0; i < image.open.size(); ++i)
        if (image.open[i]) {
            cell_of[i] = static_cast<int>(voxel_of.size());
            voxel_of.push_back(static_cast<int>(i));
        }
    const auto cells = static_cast<std::ptrdiff_t>(voxel_of.size());

    // Where the population q of a cell comes from: the neighbour against its velocity, or itself turned round at walls.
    std::vector<std::ptrdiff_t> source(static_cast<std::size_t>(n * cells));
    for (std::ptrdiff_t k = 0; k < cells; ++k) {
        const int v = voxel_of[static_cast<std::size_t>(k)], x = v % X, y = v / X % Y, z = v / X / Y;
        for (int q = 0; q < n; ++q) {
            const int* c = velocity[q];
            const int from = (x - c[0] + X) % X + X * ((y - c[1] + Y) % Y + Y * ((z - c[2] + Z) % Z));
            const int other = cell_of[static_cast<std::size_t>(from)];
            source[static_cast<std::size_t>(n * k + q)] =
                other < 0 ? n * k + opposite(q) : n * std::ptrdiff_t{other} + q;
        }
    }

    const double viscosity = 1.0 / 6, force = 1e-6;
    const float symmetric = 1 / static_cast<float>(3 * viscosity + 0.5);
    const float antisymmetric = 1 / static_cast<float>(0.5 + 3.0 / 16 / (3 * viscosity));
    std::vector<float> now(source.size(), 0.0f), next(source.size()); // deviations from rest
    LatticeBoltzmannFlow found;
    found.porosity = static_cast<double>(cells) / static_cast<double>(image.open.size());
    std::vector<double> means;
    for (;;) {
        double flux = 0;
#pragma omp parallel for reduction(+ : flux) schedule(static)
        for (std::ptrdiff_t k = 0; k < cells; ++k) {
            const std::ptrdiff_t* from = &source[static_cast<std::size_t>(n * k)];
            float f[n], density = 0, u[3] = {0, 0, 0};
            for (int q = 0; q < n; ++q) {
                f[q] = now[static_cast<std::size_t>(from[q])];
                density += f[q];
                for (int d = 0; d < 3; ++d)
                    u[d] += static_cast<float>(velocity[q][d]) * f[q];
            }
            u[axis] += static_cast<float>(force / 2);
            flux += static_cast<double>(u[axis]);
            const auto equilibrium = [&](int q) {
                const int* c = velocity[q];
                return weight[q] * (density + 3 * (static_cast<float>(c[0]) * u[0] + static_cast<float>(c[1]) * u[1] +
                                                   static_cast<float>(c[2]) * u[2]));
            };
            for (int q = 0; q < n; ++q) {
                const int o = opposite(q);
                const float e = equilibrium(q), eo = equilibrium(o);
                const float even = 0.5f * (f[q] + f[o] - e - eo), odd = 0.5f * (f[q] - f[o] - e + eo);
                const float push = (1 - antisymmetric / 2) * 3 * weight[q] * static_cast<float>(velocity[q][axis]) *
                                   static_cast<float>(force);
                next[static_cast<std::size_t>(n * k + q)] = f[q] - symmetric * even - antisymmetric * odd + push;
            }
        }
        std::swap(now, next);
        if (++found.steps % 50 != 0)
            continue;
        means.push_back(viscosity * flux / (static_cast<double>(image.open.size()) * force));
        const std::size_t count = means.size();
        if (count % 2 == 0 || count < 7)
            continue;
        const double a = means[0], b = means[count / 2], c = means[count - 1], ratio = (c - b) / (b - a);
        const double missing = b > a && ratio < 0.95 ? (c - b) * ratio / (1 - ratio) : b > a ? c : 0;
        found.permeability = c + missing;
        if (std::abs(missing) < left * c || found.steps >= 100000)
            return found;
    }
}

} // namespace study
