// Checks of the arrangement of particles: overlaps within a phase, walls and solids that are too thin, lattices that do
// not fit together, spacings too wide for the reach of a coupling.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/vector.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solver/outline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace imbibe::detail {

/// Calls f(i, nearby) for every particle i of some columns with `chosen[i]`, on several threads: nearby(g) calls
/// g(j, offset, distance) for every other particle j nearer than `reach`, m.
template <class F>
void for_surroundings(const OutlineColumns& columns, const std::vector<char>& chosen, double reach,
                      const OutlineOfScene& scene, const F& f) {
    OutlineBox box;
    for (int i = 0; i < columns.n; ++i)
        if (chosen[static_cast<std::size_t>(i)])
            box.include(columns.at(i));
    std::vector<Coordinates> places;
    std::vector<int> numbers;
    for (int i = 0; i < columns.n; ++i)
        if (const Coordinates x = columns.at(i); box.is_near(x, reach, scene.period)) {
            places.push_back(x);
            numbers.push_back(i);
        }
    const PlacesByCell cells(places, reach, scene);
    const auto block = [&](int begin, int end) {
        PlacesByCell::Lookup lookup(cells);
        for (int k = begin; k < end; ++k) {
            const int i = numbers[static_cast<std::size_t>(cells.order()[static_cast<std::size_t>(k)])];
            if (chosen[static_cast<std::size_t>(i)])
                f(i, [&](const auto& g) {
                    lookup.for_each_near(columns.at(i), [&](int j, const Coordinates& offset, double distance) {
                        if (const int other = numbers[static_cast<std::size_t>(j)]; other != i)
                            g(static_cast<std::size_t>(other), offset, distance);
                    });
                });
        }
    };
    loop_blocks(static_cast<int>(numbers.size()), 1024, scene.threads, Callable<void(int, int)>(block));
}

/// One of five particles in space, at random, and all in the plane: enough to find defects that come in rows, layers
/// and blocks.
std::vector<char> sample_of(const Outline& phase, int dim);

/// A sentence if particles with numbers from `first_new` on overlap others of their phase; else empty: sum_b V_b W over
/// 3 spacings (WendlandC2) is then above 1.3. It is 1.005 in a lattice and in a filled space in general, at most 1.26
/// where particles of a lattice are moved at random by up to 0.3 spacings, 1.4 to 1.5 where two lattices share a row,
/// and 2 where one lies in the other.
std::string warning_of_crowding(const Outline& phase, long long first_new, const OutlineOfScene& scene);

/// Is the least variance of positions around one of them, in any direction, below `least`? `sum` and `squares` are the
/// sums of their offsets and of the products of these, n the number of positions.
bool varies_less(const Coordinates& sum, std::array<Coordinates, 3> squares, int dim, double n, double least);

/// Which of the chosen particles of a phase lie in parts of fewer than `layers` layers: the variance of positions
/// across n layers is (n^2 - 1) / 12 spacings squared. Uses stress-free positions, over `reach`, m.
std::vector<char> thin_among(const std::vector<char>& chosen, const Outline& phase, double layers, double reach,
                             const OutlineOfScene& scene);
/// The thin parts of a phase.
struct ThinParts {
    long long number =
        0; ///< of particles; 0 below a hundredth of the phase: tips and edges of thick parts
    Coordinates place{}; ///< of one of them, m
};
ThinParts thin_parts(const Outline& phase, double layers, double reach, const OutlineOfScene& scene);

/// A sentence if a solid has parts that are one particle thick; else empty: the particles there do not resolve the
/// variation of the strain across, so only hourglass control or artificial stress resists bending.
std::string warning_of_one_layer(const Outline& solid, const OutlineOfScene& scene);

/// How a phase's surface runs relative to its particles, where it is smooth: not at edges, and not where it is bent by
/// more than 30 degrees over 2.5 spacings.
struct SurfaceSteps {
    long long looked_at = 0, of = 0; ///< particles of smooth surface, and of all surface
    double unevenness = 0;           ///< 0 for layers along the surface
    Coordinates place{};             ///< of the worst one, m
};
/// The root mean square of the part of t_b = sum_a V_a G_ab along the surface, over spacing^(dim - 1), with the
/// gradients G_ab = V_b L_a grad_a W_ab of ReferenceCorrection over 2 spacings, that of b itself included. A constant
/// stress pushes a particle by t_b, which must be zero inside and normal at a face for the particle to be at rest. The
/// value is 0 for faces along a lattice, 0.03 to 0.08 for fitted particles, 0.13, 0.25, 0.35, 0.34 for faces at 3, 10,
/// 17, 30 degrees to a lattice (beams 6 particles thick; tests/solver/test_set_up.cpp has the bound between). For a
/// wall, only particles nearer to a fluid than 2 spacings count. 0, too, if less than a fifth of the surface, or fewer
/// than 30 of its particles, are smooth.
SurfaceSteps surface_steps(const Outline& phase, const Outline* fluid, const OutlineOfScene& scene);
/// A sentence if the surface of a solid or wall runs in steps; else empty. @param fluid of a wall
std::string warning_of_steps(const Outline& phase, const Outline* fluid, const OutlineOfScene& scene);

/// The number of layers that a wall or solid needs against a fluid whose sums reach `reach`, m: half the reach. No
/// water passed thicker walls in tests.
inline int layers_needed(double reach, double spacing) {
    return static_cast<int>(std::ceil(0.5 * reach / spacing * (1 - 1e-9)));
}

/// A sentence if a wall or solid that is coupled to a fluid has parts with fewer layers than the fluid sees; else
/// empty. Not for couplings with a repulsion, with which one layer holds.
/// @param reach of the coupling, m
std::string warning_of_thin_wall(const Outline& wall, const Outline& fluid, double reach, const OutlineOfScene& scene);

/// A sentence if a coupling reaches less than 1.3 spacings of one of its phases; else empty: the other phase finds gaps
/// between its particles.
std::string warning_of_wide_spacing(const Outline& a, const Outline& b, double reach);

/// The position of the particles of a square or cubic lattice in its cells, in spacings from 0 to 1; empty if they do
/// not lie on a lattice along the axes.
std::optional<Coordinates> lattice_of(const Outline& phase, int dim);

/// A sentence if two coupled touching phases of one spacing lie on different lattices; else empty. Lattices shifted
/// along a plane face are fine: there the nearest particle is 1 to 1.12 spacings away, in space 1.23.
/// @param nearest the distance of their nearest particles, m
std::string warning_of_other_lattice(const Outline& a, const Outline& b, double nearest, int dim);

} // namespace imbibe::detail

#if IMBIBE_READS_CODE
#include <imbibe/solver/layout_checks_code.hpp>
#endif
