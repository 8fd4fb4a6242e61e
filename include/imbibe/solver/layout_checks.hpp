// What is doubtful about how the particles of a scene lie: some over others of their own phase, walls and solids that
// are too thin, lattices that do not fit together, spacings too wide for the reach of a coupling.
#pragma once

#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solver/outline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace imbibe::detail {

/// Calls f(i, nearby) for every particle i of some columns with `chosen[i]`, on several threads: nearby(g) calls g(offset,
/// distance) for every other particle nearer than `reach`, m.
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
                        if (numbers[static_cast<std::size_t>(j)] != i)
                            g(offset, distance);
                    });
                });
        }
    };
    loop_blocks(static_cast<int>(numbers.size()), 1024, scene.threads, Callable<void(int, int)>(block));
}

/// One of five particles in space, by chance, and all in the plane: enough to see whether there are any of a kind that
/// comes in rows, layers and blocks.
inline std::vector<char> sample_of(const Outline& phase, int dim) {
    std::vector<char> chosen(static_cast<std::size_t>(phase.size()), 1);
    if (dim == 3)
        for (std::size_t i = 0; i < chosen.size(); ++i)
            chosen[i] = (phase.ids[i] * 2654435761u >> 16) % 5 == 0;
    return chosen;
}

/// A sentence if particles with numbers from `first_new` on lie where others of their phase are, or an empty one: where
/// sum_b V_b W over 3 spacings (WendlandC2) is above 1.3. It is 1.005 in a lattice and in a filled space in general, at
/// most 1.26 where particles of a lattice are moved at random by up to 0.3 spacings, 1.4 to 1.5 where two lattices
/// share a row, and 2 where one lies in the other.
inline std::string warning_of_crowding(const Outline& phase, long long first_new, const OutlineOfScene& scene) {
    std::vector<char> added = sample_of(phase, scene.dim);
    const auto leave_out_the_old = [&] {
        for (std::size_t i = 0; i < added.size(); ++i)
            added[i] = added[i] && phase.ids[i] >= first_new;
    };
    leave_out_the_old();
    const double reach = 3 * phase.spacing;
    const double share = scene.dim == 2 ? sq(phase.spacing / reach) * WendlandC2::normalisation<2>()
                                        : power<3>(phase.spacing / reach) * WendlandC2::normalisation<3>();
    std::vector<double> filled(added.size());
    const auto count_crowded = [&] {
        for_surroundings(phase.now, added, reach, scene, [&](int i, const auto& nearby) {
            double sum = WendlandC2::value(0.0);
            nearby([&](const Coordinates&, double distance) { sum += WendlandC2::value(distance / reach); });
            filled[static_cast<std::size_t>(i)] = share * sum;
        });
        return std::count_if(filled.begin(), filled.end(), [](double sum) { return sum > 1.3; });
    };
    if (count_crowded() == 0)
        return {};
    added.assign(added.size(), 1);
    leave_out_the_old();
    const auto crowded = count_crowded();
    const auto worst = std::max_element(filled.begin(), filled.end());
    return text(phase.name, ": ", crowded, " of ", std::count(added.begin(), added.end(), char(1)),
                " particles lie where others of ", phase.name, " are: around that at ",
                scene.text_of(phase.now.at(static_cast<int>(worst - filled.begin()))), " particles fill ", *worst,
                " of the space (sum V W over 3 spacings; 1.3 is allowed). Each was added ", "with a spacing of ",
                phase.spacing, " m and has the mass density * spacing^dim, so the phase is too ",
                "heavy, and its pressure will throw them. Leave the second shape out of the first, fill(a - b, ",
                "spacing), add where there is room, or give the spacing of the points");
}

/// Is the least variance of places around one of them, in any direction, below `least`? `sum` and `squares` are the
/// sums of their offsets and of the products of these, n the number of places.
inline bool varies_less(const Coordinates& sum, std::array<Coordinates, 3> squares, int dim, double n, double least) {
    // The matrix of variances minus `least` is positive where all pivots of its elimination are.
    const auto size = static_cast<std::size_t>(dim);
    auto& m = squares;
    for (std::size_t row = 0; row < size; ++row)
        for (std::size_t k = 0; k < size; ++k)
            m[row][k] = m[row][k] / n - sum[row] * sum[k] / (n * n) - (row == k ? least : 0);
    for (std::size_t k = 0; k < size; ++k) {
        if (!(m[k][k] > 0))
            return true;
        for (std::size_t row = k + 1; row < size; ++row)
            for (std::size_t column = size; column-- > k;)
                m[row][column] -= m[row][k] / m[k][k] * m[k][column];
    }
    return false;
}

/// Which of the chosen particles of a phase lie in parts of fewer than `layers` layers: the variance of places across n
/// layers is (n^2 - 1) / 12 spacings squared. Places free of stress are looked at, over `reach`, m.
inline std::vector<char> thin_among(const std::vector<char>& chosen, const Outline& phase, double layers, double reach,
                                    const OutlineOfScene& scene) {
    std::vector<char> thin(chosen.size());
    const double least = (sq(layers - 0.5) - 1) / 12 * sq(phase.spacing);
    for_surroundings(phase.at_rest, chosen, reach, scene, [&](int i, const auto& nearby) {
        Coordinates sum{};
        std::array<Coordinates, 3> squares{};
        double n = 1;
        nearby([&](const Coordinates& offset, double) {
            for (std::size_t row = 0; row < 3; ++row) {
                sum[row] += offset[row];
                for (std::size_t k = 0; k < 3; ++k)
                    squares[row][k] += offset[row] * offset[k];
            }
            n += 1;
        });
        // Alone, a particle has no thickness to judge.
        thin[static_cast<std::size_t>(i)] = n > 1 && varies_less(sum, squares, scene.dim, n, least);
    });
    return thin;
}
/// Such parts of a phase.
struct ThinParts {
    long long number =
        0; ///< of particles; 0 where it is less than a hundredth of the phase: tips and edges of thick parts
    Coordinates place{}; ///< of one of them, m
};
inline ThinParts thin_parts(const Outline& phase, double layers, double reach, const OutlineOfScene& scene) {
    const std::vector<char> sample = sample_of(phase, scene.dim), all(sample.size(), 1);
    std::vector<char> thin = thin_among(sample, phase, layers, reach, scene);
    if (100 * std::count(thin.begin(), thin.end(), char(1)) <= std::count(sample.begin(), sample.end(), char(1)))
        return {};
    thin = thin_among(all, phase, layers, reach, scene);
    const auto one = std::find(thin.begin(), thin.end(), char(1));
    return {std::count(thin.begin(), thin.end(), char(1)), phase.at_rest.at(static_cast<int>(one - thin.begin()))};
}

/// A sentence if a solid has parts that are one particle thick, or an empty one: no particle there knows how the strain
/// changes across, so nothing but hourglass control or artificial stress resists bending.
inline std::string warning_of_one_layer(const Outline& solid, const OutlineOfScene& scene) {
    const ThinParts thin = thin_parts(solid, 2, 2.1 * solid.spacing, scene);
    if (thin.number == 0)
        return {};
    return text(
        solid.name, ": ", thin.number, " of ", solid.size(), " particles lie in parts that are one particle thick, ",
        "such as at ", scene.text_of(thin.place), ". Nothing but hourglass control or ",
        "artificial stress resists its bending, which is many times too stiff or none at all. Give it at least 2 layers, with ",
        "bending_modulus(), better 4: a spacing of ", solid.spacing / 4, " m for what is ", solid.spacing, " m thick");
}

/// How many layers a wall or solid needs against a fluid whose sums reach `reach`, m, over it: half the reach,
/// above which no water was seen to pass.
inline int layers_needed(double reach, double spacing) {
    return static_cast<int>(std::ceil(0.5 * reach / spacing * (1 - 1e-9)));
}

/// A sentence if a wall or solid that is coupled to a fluid has parts with fewer layers than that sees, or an empty
/// one. Not for couplings with a repulsion, with which one layer holds.
/// @param reach of the coupling, m
inline std::string warning_of_thin_wall(const Outline& wall, const Outline& fluid, double reach,
                                        const OutlineOfScene& scene) {
    const int needed = layers_needed(reach, wall.spacing);
    if (needed < 2) // none is thinner
        return {};
    const ThinParts thin = thin_parts(wall, needed, reach + wall.spacing, scene);
    if (thin.number == 0)
        return {};
    return text(wall.name, ": ", thin.number, " of ", wall.size(), " particles lie in parts of fewer than ", needed,
                " layers, such as at ", scene.text_of(thin.place), ". ", fluid.name, " reaches ", reach, " m, ",
                reach / wall.spacing, " spacings of ", wall.name, ", and goes through what is thinner. Give it ",
                needed, " layers or more, ", needed * wall.spacing, " m");
}

/// A sentence if a coupling reaches less than 1.3 spacings of one of its phases, or an empty one: the other phase finds
/// gaps between its particles.
inline std::string warning_of_wide_spacing(const Outline& a, const Outline& b, double reach) {
    const auto &wide = a.spacing < b.spacing ? b : a, &fine = a.spacing < b.spacing ? a : b;
    const double least = 1.3 * wide.spacing * (1 - 1e-9);
    if (reach >= least || wide.support_radius < least) // that is said of the phase itself
        return {};
    return text(fine.name, " and ", wide.name, " see each other over ", reach, " m, ", reach / wide.spacing,
                " spacings of ", wide.name, " (", wide.spacing, " m): ", fine.name,
                " finds gaps there and goes through. At least 1.3 spacings are needed: give ", wide.name,
                " a spacing of at most ", reach / 1.3, " m");
}

/// Where in its cells the particles of a square or cubic lattice lie, in spacings from 0 to 1; nothing where they do
/// not lie on one that is aligned with the axes.
inline std::optional<Coordinates> lattice_of(const Outline& phase, int dim) {
    if (phase.size() < 2)
        return {};
    Coordinates first{};
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
        const double at = phase.now.at(d, 0) / phase.spacing;
        first[d] = at - std::floor(at);
        for (int i = 1; i < phase.size(); ++i)
            if (const double away = phase.now.at(d, i) / phase.spacing - at; std::abs(away - std::round(away)) > 0.01)
                return {};
    }
    return first;
}

/// A sentence if two coupled phases of one spacing that touch lie on lattices that differ, or an empty one. Lattices
/// that are shifted along a plane face are as good: there the nearest particle is 1 to 1.12 spacings away, in
/// space 1.23.
/// @param nearest the distance of their nearest particles, m
inline std::string warning_of_other_lattice(const Outline& a, const Outline& b, double nearest, int dim) {
    const double gap = nearest / a.spacing;
    if (std::abs(a.spacing - b.spacing) > 1e-6 * a.spacing || gap > 1.6 ||
        (gap > 0.95 && gap < (dim == 2 ? 1.13 : 1.24)))
        return {};
    const auto of_a = lattice_of(a, dim), of_b = lattice_of(b, dim);
    if (!of_a || !of_b)
        return {};
    std::string shares;
    double most = 0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
        double apart = (*of_a)[d] - (*of_b)[d];
        apart = std::abs(apart - std::round(apart));
        most = std::max(most, apart);
        shares += text(d == 0 ? "" : ", ", apart);
    }
    if (most < 0.02)
        return {};
    return text(a.name, " and ", b.name, " touch (a pair is ", nearest, " m apart) and lie on lattices of spacing ",
                a.spacing, " m that differ by (", shares, ") spacings, so the gap between them is not a spacing ",
                "everywhere. Fill both with one anchor, as in fill(shape, spacing, anchor): without it a lattice ",
                "begins in the lower corner of the shape's bounds");
}

} // namespace imbibe::detail
