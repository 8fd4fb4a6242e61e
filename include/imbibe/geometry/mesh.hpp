// Bodies whose surface is a triangle mesh, used as any other shape.
#pragma once

#include <imbibe/core/parallel.hpp>
#include <imbibe/geometry/facets.hpp>
#include <imbibe/geometry/mend.hpp>
#include <imbibe/geometry/sampling.hpp>
#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace imbibe {

/// The body inside a mesh of triangles. Small: copies share the mesh.
///
/// A point is inside if the mesh's generalised winding number, the solid angle of all triangles over 4 pi, is above a
/// half. That needs no closed surface: gaps and overlaps change it little, and overlapping bodies are one. The
/// triangles are in a tree; far branches are replaced by the moments of their areas. Blocks of space away from the
/// surface are decided once, so that most points cost nothing.
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
        const double least = 1e-9 * (root.upper - root.lower).norm(); // a flat mesh needs a box as well
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

    /// The winding number at a point: 1 inside a closed mesh, 0 outside.
    [[nodiscard]] double winding_number(const Point<3>& point) const { return data_->winding(point); }

    /// Whether the point is inside.
    [[nodiscard]] bool contains(const Point<3>& point) const { return data_->contains(point); }

    /// Distance to the nearest triangle, m, negative inside. Triangles inside another body of the mesh do not count.
    [[nodiscard]] double distance(const Point<3>& point) const {
        const double away = data_->surface->distance(point);
        return data_->contains(point) ? -away : away;
    }

    /// The tightest axis-aligned box.
    [[nodiscard]] Box<3> bounds() const { return {data_->lower, data_->upper}; }

    /// Volume of the body, m^3. Exact if the mesh is closed and no bodies overlap; else counted from points, eight in
    /// each of the 64^3 blocks that the surface crosses, which takes a moment.
    [[nodiscard]] double volume() const {
        return data_->volume > 0 ? data_->volume : data_->counted_volume(available_threads());
    }

    [[nodiscard]] const MeshDamage& damage() const { return data_->damage; } ///< what was repaired, and what is left
    /// The triangles after repair, m, anticlockwise as seen from outside.
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

        /// A surface of only those triangles that have inside on one side and outside on the other.
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
        /// Decides a cube of `size` blocks a side, number `at` along each axis, or its eight parts.
        void settle(const std::array<int, 3>& at, int size) {
            const Point<3> block = (upper - lower) / blocks;
            Point<3> middle;
            for (int axis = 0; axis < 3; ++axis)
                middle[axis] = lower[axis] + (at[static_cast<std::size_t>(axis)] + 0.5) * size * block[axis];
            const double radius = 0.5 * size * block.norm();
            // At a gap the winding number changes without a triangle: there the block must be clear of a half.
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
                        // At random in its part of the block, because faces along the blocks would hit or miss all.
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
