// The distance from a point to a surface made of facets: triangles in space, line segments in the plane.
#pragma once

#include <imbibe/geometry/box.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace imbibe {

/// A flat piece of a surface: the corners (m) of a triangle in space, the ends of a line segment in the plane.
template <int dim>
using Facet = std::array<Point<dim>, static_cast<std::size_t>(dim)>;

namespace detail {

/// The point of a line segment that is nearest to `p`.
inline Point<2> nearest_point(const Facet<2>& facet, const Point<2>& p) {
    const Point<2> along = facet[1] - facet[0];
    const double length2 = along.squaredNorm();
    const double part = length2 > 0 ? std::clamp((p - facet[0]).dot(along) / length2, 0.0, 1.0) : 0.0;
    return facet[0] + part * along;
}

/// The point of a triangle that is nearest to `p`.
///
/// Source: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
inline Point<3> nearest_point(const Facet<3>& facet, const Point<3>& p) {
    const auto& [a, b, c] = facet;
    const Point<3> ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    const auto part = [](double of, double in) { return in > 0 ? of / in : 0.0; };
    if (d1 <= 0 && d2 <= 0)
        return a;
    if (d3 >= 0 && d4 <= d3)
        return b;
    if (d6 >= 0 && d5 <= d6)
        return c;
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return a + part(d1, d1 - d3) * ab;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return a + part(d2, d2 - d6) * ac;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return b + part(d4 - d3, (d4 - d3) + (d5 - d6)) * (c - b);
    const double sum = va + vb + vc;
    return a + part(vb, sum) * ab + part(vc, sum) * ac;
}

} // namespace detail

/// Facets in a tree of boxes, which finds the nearest to a point without visiting most others.
template <int dim>
class FacetTree {
public:
    /// A stretch of the sorted facets and the box round them.
    struct Node {
        Point<dim> lower, upper;  ///< corners of the box, m
        int first = 0, count = 0; ///< facets facets()[first] to facets()[first + count - 1]
        int second_half = -1;     ///< the node of the second half; the first half's is the next one; -1: a leaf
    };

    FacetTree() = default;
    /// Sorts the facets into the tree; a leaf holds at most `leaf` facets.
    explicit FacetTree(std::vector<Facet<dim>> facets, int leaf = 8) : facets_(std::move(facets)) {
        std::vector<Point<dim>> middles(facets_.size(), Point<dim>::Zero());
        for (std::size_t i = 0; i < facets_.size(); ++i)
            for (const Point<dim>& corner : facets_[i])
                middles[i] += corner / dim;
        std::vector<int> order(facets_.size());
        std::iota(order.begin(), order.end(), 0);
        if (!order.empty())
            split(order, middles, 0, static_cast<int>(order.size()), leaf);
        std::vector<Facet<dim>> sorted(facets_.size());
        for (std::size_t i = 0; i < sorted.size(); ++i)
            sorted[i] = facets_[static_cast<std::size_t>(order[i])];
        facets_ = std::move(sorted);
    }

    [[nodiscard]] const std::vector<Facet<dim>>& facets() const { return facets_; } ///< in the order of the tree
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }         ///< the first is the root

    /// The distance (m) from `point` to the nearest facet, or `within` if none is nearer.
    [[nodiscard]] double distance(const Point<dim>& point,
                                  double within = std::numeric_limits<double>::infinity()) const {
        double least = within * within;
        if (!nodes_.empty())
            search(0, point, least);
        return std::sqrt(least);
    }

private:
    int split(std::vector<int>& order, const std::vector<Point<dim>>& middles, int first, int last, int leaf) {
        const int here = static_cast<int>(nodes_.size());
        Node node;
        node.first = first, node.count = last - first;
        node.lower.setConstant(std::numeric_limits<double>::max());
        node.upper = -node.lower;
        Point<dim> low = node.lower, high = node.upper; // of the middles
        for (int k = first; k < last; ++k) {
            const auto i = static_cast<std::size_t>(order[static_cast<std::size_t>(k)]);
            for (const Point<dim>& corner : facets_[i]) {
                node.lower = node.lower.cwiseMin(corner).eval();
                node.upper = node.upper.cwiseMax(corner).eval();
            }
            low = low.cwiseMin(middles[i]).eval();
            high = high.cwiseMax(middles[i]).eval();
        }
        nodes_.push_back(node);
        if (node.count > leaf) {
            int axis = 0;
            (high - low).maxCoeff(&axis);
            const int half = first + node.count / 2;
            std::nth_element(order.begin() + first, order.begin() + half, order.begin() + last, [&](int a, int b) {
                const double x = middles[static_cast<std::size_t>(a)][axis],
                             y = middles[static_cast<std::size_t>(b)][axis];
                return x < y || (x == y && a < b);
            });
            split(order, middles, first, half, leaf);
            const int second = split(order, middles, half, last, leaf);
            nodes_[static_cast<std::size_t>(here)].second_half = second;
        }
        return here;
    }

    [[nodiscard]] static double to_box(const Node& node, const Point<dim>& p) {
        return (node.lower - p).cwiseMax(p - node.upper).cwiseMax(Point<dim>::Zero()).squaredNorm();
    }

    /// Lowers `least`, a squared distance, to that of the nearest facet under a node.
    void search(int number, const Point<dim>& p, double& least) const {
        const Node& node = nodes_[static_cast<std::size_t>(number)];
        if (node.second_half < 0) {
            for (int i = node.first; i < node.first + node.count; ++i)
                least =
                    std::min(least, (detail::nearest_point(facets_[static_cast<std::size_t>(i)], p) - p).squaredNorm());
            return;
        }
        int nearer = number + 1, farther = node.second_half;
        double to_nearer = to_box(nodes_[static_cast<std::size_t>(nearer)], p),
               to_farther = to_box(nodes_[static_cast<std::size_t>(farther)], p);
        if (to_farther < to_nearer) {
            std::swap(nearer, farther);
            std::swap(to_nearer, to_farther);
        }
        if (to_nearer < least)
            search(nearer, p, least);
        if (to_farther < least)
            search(farther, p, least);
    }

    std::vector<Facet<dim>> facets_;
    std::vector<Node> nodes_;
};

} // namespace imbibe
