// Triangle meshes as files have them, and their repair: copies, gaps, pieces that face the wrong way.
#pragma once

#include <imbibe/geometry/facets.hpp>
#include <imbibe/geometry/groups.hpp>
#include <imbibe/geometry/point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace imbibe {

/// A mesh as in a file: corners, and triangles of three corner numbers.
struct Triangles {
    std::vector<Point<3>> corners;             ///< m
    std::vector<std::array<int, 3>> triangles; ///< numbers of corners, anticlockwise as seen from outside
};

/// What mend() found and did.
struct MeshDamage {
    long long degenerate = 0; ///< triangles without area that were dropped
    long long copies = 0;     ///< duplicate triangles that were dropped
    long long inner = 0;      ///< triangles between two touching bodies that were dropped
    long long flipped = 0;    ///< triangles that were turned to face like their neighbours
    int inside_out = 0;       ///< pieces that faced inwards, and were turned
    long long open_edges = 0; ///< edges of one triangle only that are left: gaps in the surface
    long long odd_edges = 0;  ///< edges of more than two triangles that are left
    int parts = 0;            ///< pieces of surface connected by edges
};

namespace detail {

/// Gives the same corner number to all corners nearer to each other than a millionth of the mesh's size.
inline Triangles welded(const Triangles& mesh) {
    Point<3> lower = mesh.corners.front(), upper = lower;
    for (const auto& x : mesh.corners) {
        lower = lower.cwiseMin(x).eval();
        upper = upper.cwiseMax(x).eval();
    }
    const double grain = std::max(1e-6 * (upper - lower).norm(), std::numeric_limits<double>::min());
    struct Hash {
        std::size_t operator()(const std::array<std::int64_t, 3>& key) const {
            std::uint64_t hash = 0;
            for (const auto k : key) {
                hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15ULL;
                hash ^= hash >> 32;
            }
            return hash;
        }
    };
    std::unordered_map<std::array<std::int64_t, 3>, int, Hash> known;
    known.reserve(mesh.corners.size());
    Triangles result;
    std::vector<int> number(mesh.corners.size());
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        std::array<std::int64_t, 3> key;
        for (int axis = 0; axis < 3; ++axis)
            key[static_cast<std::size_t>(axis)] = std::llround((mesh.corners[i][axis] - lower[axis]) / grain);
        const auto [place, is_new] = known.try_emplace(key, static_cast<int>(result.corners.size()));
        if (is_new)
            result.corners.push_back(mesh.corners[i]);
        number[i] = place->second;
    }
    result.triangles = mesh.triangles;
    for (auto& triangle : result.triangles)
        for (int& corner : triangle)
            corner = number[static_cast<std::size_t>(corner)];
    return result;
}

/// An edge of a triangle, from the lower corner number to the higher, and whether the triangle runs along it the other
/// way.
struct Edge {
    int low, high;
    std::uint32_t triangle;
    bool backwards;
    bool operator<(const Edge& other) const {
        return std::pair{low, high} < std::pair{other.low, other.high} ||
               (low == other.low && high == other.high && triangle < other.triangle);
    }
    [[nodiscard]] bool along(const Edge& other) const { return low == other.low && high == other.high; }
};

/// Calls f(first, last) for the edges of all triangles, grouped by line.
template <class F>
void for_edges(const std::vector<std::array<int, 3>>& triangles, const F& f) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = triangles[t][k], to = triangles[t][(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint32_t>(t), from > to});
        }
    std::sort(edges.begin(), edges.end());
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::find_if(first, edges.end(), [&](const Edge& e) { return !e.along(*first); });
        f(first, last);
        first = last;
    }
}

/// Twice the area of a triangle, as a vector along its normal.
inline Point<3> double_area(const Triangles& mesh, const std::array<int, 3>& t) {
    const auto at = [&](std::size_t k) -> const Point<3>& { return mesh.corners[static_cast<std::size_t>(t[k])]; };
    const Point<3> a = at(1) - at(0), b = at(2) - at(0);
    return cross(a, b);
}

/// The volume inside a closed mesh, relative to its first corner, so that a mesh far from the origin keeps its digits;
/// negative if it faces inwards.
inline double signed_volume(const Triangles& mesh) {
    const Point<3> origin = mesh.corners.empty() ? Point<3>::Zero() : mesh.corners.front();
    double sum = 0;
    for (const auto& t : mesh.triangles) {
        const Point<3> a = mesh.corners[static_cast<std::size_t>(t[0])] - origin;
        sum += a.dot(double_area(mesh, t)) / 6;
    }
    return sum;
}

/// The solid angle of a triangle seen from a point, over 4 pi. Source: van Oosterom and Strackee (1983).
inline double part_of_a_turn(const Facet<3>& facet, const Point<3>& point) {
    const Point<3> a = facet[0] - point, b = facet[1] - point, c = facet[2] - point;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    return std::atan2(a.dot(cross(b, c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y) /
           (2 * std::numbers::pi);
}

/// Leaves one triangle of each set of three corners. Returns, for each that is left, whether there were copies that
/// faced the other way.
inline std::vector<char> keep_one_of_each(std::vector<std::array<int, 3>>& triangles, MeshDamage& found) {
    const auto turns_up = [](const std::array<int, 3>& t) { // from its least corner on, up or down?
        const auto least = static_cast<std::size_t>(std::min_element(t.begin(), t.end()) - t.begin());
        return t[(least + 1) % 3] < t[(least + 2) % 3];
    };
    const auto corners = [&](std::size_t i) { // in their order
        auto key = triangles[i];
        std::sort(key.begin(), key.end());
        return key;
    };
    std::vector<std::size_t> order(triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) {
        return std::pair{corners(a), a} < std::pair{corners(b), b};
    });
    std::vector<std::array<int, 3>> once;
    std::vector<char> both_ways;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto& triangle = triangles[order[k]];
        if (k > 0 && corners(order[k]) == corners(order[k - 1])) {
            ++found.copies;
            both_ways.back() = both_ways.back() || turns_up(once.back()) != turns_up(triangle);
        } else {
            once.push_back(triangle);
            both_ways.push_back(0);
        }
    }
    triangles.swap(once);
    return both_ways;
}

/// Triangles connected across edges of two.
inline Groups pieces_of(const std::vector<std::array<int, 3>>& triangles) {
    Groups groups(triangles.size());
    for_edges(triangles, [&](auto first, auto last) {
        if (last - first == 2)
            groups.join(first->triangle, first[1].triangle);
    });
    return groups;
}

/// Drops pieces that exist facing both ways and end at other pieces: walls between two bodies.
inline void drop_walls_between(std::vector<std::array<int, 3>>& triangles, const std::vector<char>& both_ways,
                               MeshDamage& found) {
    Groups pieces = pieces_of(triangles);
    std::vector<char> ends_at_others(triangles.size(), 0), faces_one_way(triangles.size(), 0);
    for_edges(triangles, [&](auto first, auto last) {
        for (auto edge = first; last - first > 2 && edge != last; ++edge)
            ends_at_others[pieces.of(edge->triangle)] = 1;
    });
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (!both_ways[t])
            faces_one_way[pieces.of(t)] = 1;
    std::vector<std::array<int, 3>> kept;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        if (ends_at_others[pieces.of(t)] && !faces_one_way[pieces.of(t)])
            ++found.inner;
        else
            kept.push_back(triangles[t]);
    found.copies -= found.inner; // of these, one too was called a copy
    triangles.swap(kept);
}

/// Turns triangles to face as most of their piece does, and pieces outwards, except those around a cavity.
inline void face_outwards(Triangles& mesh, MeshDamage& found) {
    auto& triangles = mesh.triangles;
    const auto turn = [&](std::size_t t) { std::swap(triangles[t][1], triangles[t][2]); };
    std::vector<std::vector<std::pair<std::uint32_t, bool>>> neighbours(triangles.size()); // and whether they agree
    for_edges(triangles, [&](auto first, auto last) {
        found.open_edges += last - first == 1;
        found.odd_edges += last - first > 2;
        if (last - first == 2) {
            const bool agree = first->backwards != first[1].backwards;
            neighbours[first->triangle].push_back({first[1].triangle, agree});
            neighbours[first[1].triangle].push_back({first->triangle, agree});
        }
    });
    std::vector<signed char> sense(triangles.size(), 0);
    std::vector<std::vector<std::uint32_t>> pieces;
    for (std::uint32_t seed = 0; seed < triangles.size(); ++seed) {
        if (sense[seed] != 0)
            continue;
        auto& piece = pieces.emplace_back(1, seed);
        sense[seed] = 1;
        double kept = 0;
        for (std::size_t k = 0; k < piece.size(); ++k) {
            kept += sense[piece[k]] * double_area(mesh, triangles[piece[k]]).norm();
            for (const auto& [next, agree] : neighbours[piece[k]])
                if (sense[next] == 0) {
                    sense[next] = static_cast<signed char>(agree ? sense[piece[k]] : -sense[piece[k]]);
                    piece.push_back(next);
                }
        }
        for (const auto t : piece)
            if ((sense[t] > 0) != (kept > 0)) {
                turn(t);
                ++found.flipped;
            }
    }
    found.parts = static_cast<int>(pieces.size());

    if (signed_volume(mesh) < 0) {
        found.inside_out = found.parts;
        for (std::size_t t = 0; t < triangles.size(); ++t)
            turn(t);
    }
    const auto facet = [&](std::size_t t) {
        const auto at = [&](std::size_t k) { return mesh.corners[static_cast<std::size_t>(triangles[t][k])]; };
        return Facet<3>{at(0), at(1), at(2)};
    };
    if (pieces.size() > 1 && pieces.size() <= 1000) // not of a soup
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            double volume = 0, turns = 0; // of the piece; of the others around it
            const Point<3> place = facet(pieces[p][0])[0];
            for (const auto t : pieces[p])
                volume += (facet(t)[0] - place).dot(double_area(mesh, triangles[t])) / 6;
            if (volume >= 0)
                continue;
            for (std::size_t other = 0; other < pieces.size(); ++other)
                for (const auto t : pieces[other])
                    turns += other == p ? 0 : part_of_a_turn(facet(t), place);
            if (turns < 0.5) {
                ++found.inside_out;
                for (const auto t : pieces[p])
                    turn(t);
            }
        }
}

} // namespace detail

/// Repairs the mesh: corners in one place become one, triangles without area are dropped, one of duplicate triangles is
/// kept (none where two bodies share a wall), triangles that face the wrong way are turned to face as most of their
/// piece, and so are whole pieces that face inwards, except around a cavity. Gaps stay open: TriangleMesh decides what
/// is inside even so.
///
/// Throws Error for a mesh without triangles, for corners that are not finite, and for missing corner numbers.
/// @param mesh as read
/// @param damage receives what was found, if given
[[nodiscard]] inline Triangles mend(const Triangles& mesh, MeshDamage* damage = nullptr) {
    require(!mesh.triangles.empty(), "mend: the mesh has no triangles. Look at the file it is from.");
    for (std::size_t i = 0; i < mesh.corners.size(); ++i)
        if (!mesh.corners[i].allFinite())
            throw Error(text("mend: corner ", i, " of the mesh is at ", point_text<3>(mesh.corners[i]),
                             "; coordinates must be finite. Look at the file it is from."));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const int corner : mesh.triangles[t])
            if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.corners.size())
                throw Error(text("mend: triangle ", t, " of the mesh has corner ", corner, "; there are corners 0 to ",
                                 static_cast<long long>(mesh.corners.size()) - 1, "."));
    MeshDamage found;
    Triangles result = detail::welded(mesh);
    const auto before = static_cast<long long>(result.triangles.size());
    std::erase_if(result.triangles, [&](const auto& t) {
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0] || !(detail::double_area(result, t).norm() > 0);
    });
    found.degenerate = before - static_cast<long long>(result.triangles.size());
    require(!result.triangles.empty(), "mend: none of the ", before, " triangles of the mesh has an area.");
    const std::vector<char> both_ways = detail::keep_one_of_each(result.triangles, found);
    detail::drop_walls_between(result.triangles, both_ways, found);
    detail::face_outwards(result, found);
    if (damage != nullptr)
        *damage = found;
    return result;
}

} // namespace imbibe
