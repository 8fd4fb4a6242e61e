// Bodies whose surface is a mesh of triangles: mended where the mesh is damaged, and used as any other shape.
#pragma once

#include <imbibe/core/parallel.hpp>
#include <imbibe/geometry/facets.hpp>
#include <imbibe/geometry/sampling.hpp>
#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace imbibe {

/// A mesh as files have it: places, and triangles that name three of them.
struct Triangles {
    std::vector<Point<3>> corners;             ///< m
    std::vector<std::array<int, 3>> triangles; ///< numbers of corners, anticlockwise as seen from outside
};

/// What mend() found and did.
struct MeshDamage {
    long long degenerate = 0; ///< triangles without area that were dropped
    long long copies = 0;     ///< triangles that were there more than once, and were dropped but for one
    long long inner = 0;      ///< triangles between two bodies that touch, which were dropped
    long long flipped = 0;    ///< triangles that were turned to face as their neighbours do
    int inside_out = 0;       ///< pieces that faced inwards, and were turned
    long long open_edges = 0; ///< edges of one triangle only, after all this: the surface has gaps there
    long long odd_edges = 0;  ///< edges of more than two triangles, after all this
    int parts = 0;            ///< pieces of surface that hang together by edges
};

namespace detail {

/// Which things belong together: joined two by two.
class Groups {
public:
    explicit Groups(std::size_t number) : parent_(number) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t of(std::size_t i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) { parent_[of(i)] = of(j); }

private:
    std::vector<std::size_t> parent_;
};

/// The same corner number for all corners in one place, or nearer than a millionth of the mesh's size.
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

/// An edge of a triangle, from the corner of the lower number to that of the higher, and whether the triangle goes
/// along it the other way.
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

/// Calls f(first, last) for the edges of all triangles, those along one line together.
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

/// The volume inside a closed mesh, from the middle of its first corner, so that a mesh far from the origin keeps its
/// digits; negative where it faces inwards.
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

/// Leaves one triangle of each set of three corners. Returns, for each that is left, whether there were some that faced
/// the other way.
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

/// Triangles that hang together across edges of two.
inline Groups pieces_of(const std::vector<std::array<int, 3>>& triangles) {
    Groups groups(triangles.size());
    for_edges(triangles, [&](auto first, auto last) {
        if (last - first == 2)
            groups.join(first->triangle, first[1].triangle);
    });
    return groups;
}

/// Drops pieces that were there facing both ways and end at other pieces: walls between two bodies.
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

/// Turns triangles: each to face as most of its piece does, and pieces outwards, but for those round a cavity.
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
            double volume = 0, turns = 0; // of the piece; of the others round it
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

/// The mesh mended: corners in one place become one, triangles without area are dropped, of triangles that are there
/// twice one is kept (none where two bodies share a wall), those that face the wrong way are turned to face as most of
/// their piece do, and whole pieces that face inwards, but for those round a cavity. Gaps stay open: what is inside is
/// decided by TriangleMesh all the same.
///
/// Throws Error for a mesh without triangles, for corners that are not finite, and for numbers of corners that are not
/// there.
/// @param mesh as it was read
/// @param damage what was found, if asked for
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

/// The body inside a mesh of triangles. Small: copies share the mesh.
///
/// A point is inside where the mesh goes round it more than half a time: its generalised winding number, the solid
/// angle of all triangles over 4 pi, is above a half. That needs no closed surface: gaps and overlaps change it little,
/// and bodies that overlap are one. The triangles are in a tree; of a far branch the moments of its areas stand for the
/// triangles. Blocks of space that the surface does not come near are settled once, so that most points cost nothing.
///
/// Source: Jacobson, Kavan and Sorkine-Hornung (2013); Barill, Dickson, Schmidt, Levin and Jacobson (2018), with a
/// dipole and its first derivative, beyond 2 radii of a branch.
class TriangleMesh {
public:
    /// The mesh is mended first. Throws Error as mend() does.
    explicit TriangleMesh(const Triangles& mesh, int threads = 0) {
        auto data = std::make_shared<Data>();
        const Triangles mended = mend(mesh, &data->damage);
        std::vector<Facet<3>> facets;
        for (const auto& t : mended.triangles)
            facets.push_back({mended.corners[static_cast<std::size_t>(t[0])],
                              mended.corners[static_cast<std::size_t>(t[1])],
                              mended.corners[static_cast<std::size_t>(t[2])]});
        data->tree = FacetTree<3>(std::move(facets));
        data->take_moments();
        const auto& root = data->tree.nodes().front();
        const double least = 1e-9 * (root.upper - root.lower).norm(); // a flat mesh has a box all the same
        for (int axis = 0; axis < 3; ++axis) {
            data->lower[axis] = root.lower[axis];
            data->upper[axis] = std::max(root.upper[axis], root.lower[axis] + least);
        }
        data->surface = &data->tree;
        if (data->damage.parts > 1)
            data->drop_hidden(threads > 0 ? threads : available_threads());
        data->settle_blocks(threads > 0 ? threads : available_threads());
        const bool closed = data->damage.open_edges == 0 && data->surface == &data->tree;
        data->volume = closed ? detail::signed_volume(mended) : 0;
        data_ = std::move(data);
    }

    /// How often the mesh goes round a point: 1 inside a closed one, 0 outside.
    [[nodiscard]] double winding_number(const Point<3>& point) const { return data_->winding(point); }

    /// Whether the point is inside.
    [[nodiscard]] bool contains(const Point<3>& point) const { return data_->contains(point); }

    /// Distance to the nearest triangle, m, negative inside. Triangles inside of another body of the mesh do not count.
    [[nodiscard]] double distance(const Point<3>& point) const {
        const double away = data_->surface->distance(point);
        return data_->contains(point) ? -away : away;
    }

    /// The tightest axis-aligned box.
    [[nodiscard]] Box<3> bounds() const { return {data_->lower, data_->upper}; }

    /// Of the body, m^3. Exact where the mesh is closed and no bodies overlap; else counted from points, eight in each
    /// of the 64^3 blocks that the surface runs through, which takes a moment.
    [[nodiscard]] double volume() const {
        return data_->volume > 0 ? data_->volume : data_->counted_volume(available_threads());
    }

    [[nodiscard]] const MeshDamage& damage() const { return data_->damage; } ///< what was mended, and what is left
    /// The triangles after mending, m, anticlockwise as seen from outside.
    [[nodiscard]] const std::vector<Facet<3>>& facets() const { return data_->tree.facets(); }

private:
    struct Moments {
        Point<3> centre = Point<3>::Zero(), area = Point<3>::Zero(); // m; sum of the areas as vectors, m^2
        Eigen::Matrix3d first = Eigen::Matrix3d::Zero();             // sum of (middle - centre) area^T, m^3
        double radius = 0;                                           // of the ball round the branch, m
    };
    enum class Settled : char { no, inside, outside };

    struct Data {
        MeshDamage damage;
        FacetTree<3> tree, visible;
        const FacetTree<3>* surface = nullptr; // what distances are to: one of the two
        std::vector<Moments> moments;          // of the nodes of `tree`
        Point<3> lower, upper;
        static constexpr int blocks = 64; // each way
        std::vector<Settled> settled;
        double volume = 0; // m^3, where the triangles tell it
        Data() = default;
        Data(const Data&) = delete;
        Data& operator=(const Data&) = delete;

        void take_moments() {
            moments.resize(tree.nodes().size());
            for (std::size_t n = 0; n < moments.size(); ++n) {
                const auto& node = tree.nodes()[n];
                Moments& m = moments[n];
                const auto for_facets = [&](const auto& f) {
                    for (int i = node.first; i < node.first + node.count; ++i) {
                        const auto& [a, b, c] = tree.facets()[static_cast<std::size_t>(i)];
                        f(Point<3>((a + b + c) / 3), Point<3>(detail::cross(b - a, c - a) / 2));
                    }
                };
                double sum = 0;
                for_facets([&](const Point<3>& middle, const Point<3>& area) {
                    m.area += area;
                    m.centre += area.norm() * middle;
                    sum += area.norm();
                });
                m.centre /= sum;
                for_facets([&](const Point<3>& middle, const Point<3>& area) {
                    m.first += (middle - m.centre) * area.transpose();
                });
                for (int i = node.first; i < node.first + node.count; ++i)
                    for (const auto& corner : tree.facets()[static_cast<std::size_t>(i)])
                        m.radius = std::max(m.radius, (corner - m.centre).norm());
            }
        }

        [[nodiscard]] double winding(const Point<3>& point, int number = 0) const {
            const Moments& m = moments[static_cast<std::size_t>(number)];
            const Point<3> r = m.centre - point;
            const double r2 = r.squaredNorm();
            if (r2 > 4 * m.radius * m.radius) {
                const double k = 1 / std::sqrt(r2), k3 = k * k * k;
                const double first = m.first.trace() * k3 - 3 * r.dot(m.first * r) * k3 * k * k;
                return (m.area.dot(r) * k3 + first) / (4 * std::numbers::pi);
            }
            const auto& node = tree.nodes()[static_cast<std::size_t>(number)];
            if (node.second_half >= 0)
                return winding(point, number + 1) + winding(point, node.second_half);
            double sum = 0;
            for (int i = node.first; i < node.first + node.count; ++i)
                sum += detail::part_of_a_turn(tree.facets()[static_cast<std::size_t>(i)], point);
            return sum;
        }

        /// A surface of those triangles only that have inside on one side and outside on the other.
        void drop_hidden(int threads) {
            std::vector<char> hidden(tree.facets().size(), 0);
            const double step = 1e-6 * (upper - lower).norm();
            parallel_blocks(static_cast<int>(hidden.size()), 256, threads, [&](int begin, int end) {
                for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                    const auto& [a, b, c] = tree.facets()[i];
                    const Point<3> middle = (a + b + c) / 3;
                    const Point<3> out = step * detail::cross(b - a, c - a).stableNormalized();
                    hidden[i] = (winding(middle + out) > 0.5) == (winding(middle - out) > 0.5);
                }
            });
            std::vector<Facet<3>> seen;
            for (std::size_t i = 0; i < hidden.size(); ++i)
                if (!hidden[i])
                    seen.push_back(tree.facets()[i]);
            if (seen.size() < hidden.size() && !seen.empty()) {
                visible = FacetTree<3>(std::move(seen));
                surface = &visible;
            }
        }

        void settle_blocks(int threads) {
            settled.assign(static_cast<std::size_t>(blocks) * blocks * blocks, Settled::no);
            constexpr int coarse = 8;
            parallel_for(coarse * coarse * coarse, threads, [&](int k) {
                settle({k % coarse, k / coarse % coarse, k / (coarse * coarse)}, blocks / coarse);
            });
        }
        /// Settles a cube of `size` blocks a side, number `at` along each axis, or its eight parts.
        void settle(const std::array<int, 3>& at, int size) {
            const Point<3> block = (upper - lower) / blocks;
            Point<3> middle;
            for (int axis = 0; axis < 3; ++axis)
                middle[axis] = lower[axis] + (at[static_cast<std::size_t>(axis)] + 0.5) * size * block[axis];
            const double radius = 0.5 * size * block.norm();
            // Beside a gap the winding number changes where no triangle is: there the block must be clear of a half.
            const double clear = damage.open_edges > 0 ? 0.25 : 0, away = damage.open_edges > 0 ? 2 * radius : radius;
            double turns = 0;
            if (tree.distance(middle, away) >= away && std::abs((turns = winding(middle)) - 0.5) >= clear) {
                const Settled side = turns > 0.5 ? Settled::inside : Settled::outside;
                for (int z = at[2] * size; z < (at[2] + 1) * size; ++z)
                    for (int y = at[1] * size; y < (at[1] + 1) * size; ++y)
                        for (int x = at[0] * size; x < (at[0] + 1) * size; ++x)
                            settled[static_cast<std::size_t>((z * blocks + y) * blocks + x)] = side;
            } else if (size > 1) {
                for (int part = 0; part < 8; ++part)
                    settle({2 * at[0] + (part & 1), 2 * at[1] + (part >> 1 & 1), 2 * at[2] + (part >> 2)}, size / 2);
            }
        }

        [[nodiscard]] double counted_volume(int threads) const {
            constexpr int parts = 8;
            std::array<long long, blocks> hits{};
            parallel_for(blocks, threads, [&](int z) {
                for (int k = 0; k < blocks * blocks; ++k) {
                    const Settled known = settled[static_cast<std::size_t>(z * blocks * blocks + k)];
                    auto& sum = hits[static_cast<std::size_t>(z)];
                    if (known != Settled::no) {
                        sum += known == Settled::inside ? parts : 0;
                        continue;
                    }
                    for (int part = 0; part < parts; ++part) {
                        // Anywhere in its part of the block, as faces along the blocks would hit or miss all.
                        const auto number = static_cast<std::uint64_t>((z * blocks * blocks + k) * 8 + part);
                        Point<3> at(k % blocks, static_cast<double>(k / blocks), z);
                        for (int axis = 0; axis < 3; ++axis)
                            at[axis] +=
                                0.5 * ((part >> axis & 1) + random_number(1, number, static_cast<std::uint64_t>(axis)));
                        sum += winding(lower + at.cwiseProduct(upper - lower) / blocks) > 0.5;
                    }
                }
            });
            const auto sum = static_cast<double>(std::accumulate(hits.begin(), hits.end(), 0LL));
            return sum / parts * ((upper - lower) / blocks).prod();
        }

        [[nodiscard]] bool contains(const Point<3>& point) const {
            if (!((point.array() >= lower.array()).all() && (point.array() <= upper.array()).all()))
                return false;
            int index = 0;
            for (int axis = 2; axis >= 0; --axis) {
                const double at = (point[axis] - lower[axis]) / (upper[axis] - lower[axis]) * blocks;
                index = index * blocks + std::clamp(static_cast<int>(at), 0, blocks - 1);
            }
            const Settled known = settled[static_cast<std::size_t>(index)];
            return known == Settled::no ? winding(point) > 0.5 : known == Settled::inside;
        }
    };

    std::shared_ptr<const Data> data_;
};

} // namespace imbibe
