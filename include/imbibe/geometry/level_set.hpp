// The signed distance to the surface of any shape, on a grid.
#pragma once

#include <imbibe/core/parallel.hpp>
#include <imbibe/geometry/facets.hpp>
#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <vector>

namespace imbibe {

/// A shape that has its distance to the surface: `double distance(const Point<dim>&) const`, m, exact, negative inside.
/// For other shapes LevelSet computes it from contains() alone.
template <class S>
concept ShapeWithDistance = AnyShape<S> && requires(const S& shape, const Point<shape_dimension<S>>& point) {
    { shape.distance(point) } -> std::convertible_to<double>;
};

/// The signed distance (m, negative inside) to the surface of a shape, at the nodes of a grid, linear between them, and
/// limited to -band ... band.
///
/// For a shape with a distance() the values at the nodes are exact. For others flat pieces approximate the surface:
/// where a line between two nodes has one end in the shape, bisection finds its intersection with the surface, and
/// these points are the corners of the pieces (triangles of six tetrahedra a cell). On curved surfaces the error is
/// about cell^2/(8 radius); an edge is cut off by up to 0.35 cells; parts thinner than a cell may be missed.
template <int dim>
class LevelSet {
public:
    /// Throws Error if the shape is unbounded or the grid has more than 4e9 nodes.
    /// @param shape any shape
    /// @param cell distance of the nodes, m
    /// @param anchor a node, m
    /// @param band the limit of the distance, m
    /// @param threads how many threads compute it; 0: all of the machine
    template <AnyShape S>
    LevelSet(const S& shape, double cell, const Point<dim>& anchor, double band, int threads = 0)
        : cell_(cell), band_(band), threads_(threads > 0 ? threads : available_threads()) {
        const Box<dim> bounds = shape.bounds();
        require(bounds.bounded(), "LevelSet: the shape has no bounds (lower ", point_text<dim>(bounds.lower()),
                ", upper ", point_text<dim>(bounds.upper()), "). Intersect it with a box: shape & Box.");
        detail::require_positive("LevelSet", "cell", cell, "Give the distance of the nodes in metres.");
        double number = 1;
        for (int axis = 0; axis < dim; ++axis) {
            const double below = std::floor((bounds.lower()[axis] - band - anchor[axis]) / cell);
            const double above = std::ceil((bounds.upper()[axis] + band - anchor[axis]) / cell);
            lower_[axis] = anchor[axis] + below * cell;
            number *= above - below + 1;
            require(number <= 4e9, "LevelSet: a cell of ", cell, " m makes more than 4e9 nodes in a box of sides ",
                    point_text<dim>(bounds.size()), ". Give cell and shape in the same unit, metres.");
            nodes_[slot(axis)] = static_cast<int>(above - below) + 1;
        }
        values_.resize(static_cast<std::size_t>(number));
        if constexpr (ShapeWithDistance<S>) {
            measure([&](const Point<dim>& x, double) { return shape.distance(x); });
        } else {
            const std::vector<char> inside = sides_of(shape);
            const FacetTree<dim> surface(facets_of(shape, inside));
            measure([&](const Point<dim>& x, double within) {
                const double away = surface.distance(x, within);
                return inside[index_near(x)] != 0 ? -away : away;
            });
        }
        volume_ = volume_of(shape);
    }

    /// The signed distance at a point, m; at most `band` outside.
    [[nodiscard]] double operator()(const Point<dim>& point) const { return value(point, nullptr); }
    /// The same with its gradient, without unit: the outward normal of the surface, of length 1 except near edges and
    /// beyond the band.
    [[nodiscard]] double operator()(const Point<dim>& point, Point<dim>& gradient) const {
        return value(point, &gradient);
    }
    [[nodiscard]] double cell() const { return cell_; }     ///< distance of the nodes, m
    [[nodiscard]] double band() const { return band_; }     ///< how far distances are followed, m
    [[nodiscard]] double volume() const { return volume_; } ///< of the shape, m^dim: its own volume() or counted

    using Index = std::array<int, static_cast<std::size_t>(dim)>;              ///< of a node along each axis, from 0
    [[nodiscard]] const Index& nodes() const { return nodes_; }                ///< how many there are along each axis
    [[nodiscard]] const std::vector<float>& values() const { return values_; } ///< at the nodes, m; x runs fastest

private:
    static constexpr std::size_t slot(int axis) { return static_cast<std::size_t>(axis); }
    static constexpr int corners = 1 << dim;
    static constexpr std::size_t lines = std::size_t{corners} * corners; // between two corners of a cell
    static constexpr int block = 4; // nodes each way that are settled together if they are far from the surface

    [[nodiscard]] std::size_t flat(const Index& node) const {
        std::size_t result = 0;
        for (int axis = dim; axis-- > 0;)
            result = result * static_cast<std::size_t>(nodes_[slot(axis)]) + static_cast<std::size_t>(node[slot(axis)]);
        return result;
    }
    [[nodiscard]] Point<dim> place(const Index& node) const {
        Point<dim> x = lower_;
        for (int axis = 0; axis < dim; ++axis)
            x[axis] += node[slot(axis)] * cell_;
        return x;
    }
    [[nodiscard]] std::size_t index_near(const Point<dim>& x) const {
        Index node;
        for (int axis = 0; axis < dim; ++axis)
            node[slot(axis)] =
                std::clamp(static_cast<int>(std::lround((x[axis] - lower_[axis]) / cell_)), 0, nodes_[slot(axis)] - 1);
        return flat(node);
    }
    /// Calls f(index) for all indices from `first` to one below `last`, x fastest.
    template <class F>
    static void for_all(const Index& first, const Index& last, const F& f) {
        for (int axis = 0; axis < dim; ++axis)
            if (first[slot(axis)] >= last[slot(axis)])
                return;
        Index i = first;
        for (;;) {
            f(i);
            int axis = 0;
            while (axis < dim && ++i[slot(axis)] >= last[slot(axis)]) {
                i[slot(axis)] = first[slot(axis)];
                ++axis;
            }
            if (axis == dim)
                return;
        }
    }
    /// The same, in slices across the last axis on several threads: f(index, slice).
    template <class F>
    void for_slices(const Index& last, const F& f) const {
        parallel_for(last[dim - 1], threads_, [&](int slice) {
            Index from{}, to = last;
            from[dim - 1] = slice, to[dim - 1] = slice + 1;
            for_all(from, to, [&](const Index& i) { f(i, slice); });
        });
    }

    /// The values at the nodes. `distance(x, within)` is the signed distance, or `within` with the sign of it.
    template <class Distance>
    void measure(const Distance& distance) {
        Index blocks;
        for (int axis = 0; axis < dim; ++axis)
            blocks[slot(axis)] = (nodes_[slot(axis)] + block - 1) / block;
        const int half = block / 2; // a node near the middle of a block, and the way from there to its corners
        const double radius = half * cell_ * std::sqrt(double(dim));
        for_slices(blocks, [&](const Index& of, int) {
            Index first, last, middle;
            for (int axis = 0; axis < dim; ++axis) {
                first[slot(axis)] = block * of[slot(axis)];
                middle[slot(axis)] = std::min(first[slot(axis)] + half, nodes_[slot(axis)] - 1);
                last[slot(axis)] = std::min(first[slot(axis)] + block, nodes_[slot(axis)]);
            }
            const double about = distance(place(middle), band_ + radius);
            for_all(first, last, [&](const Index& node) {
                const double at = std::abs(about) >= band_ + radius ? about : distance(place(node), band_);
                values_[flat(node)] = static_cast<float>(std::clamp(at, -band_, band_));
            });
        });
    }

    template <class S>
    [[nodiscard]] std::vector<char> sides_of(const S& shape) const {
        std::vector<char> inside(values_.size());
        for_slices(nodes_, [&](const Index& node, int) { inside[flat(node)] = shape.contains(place(node)) ? 1 : 0; });
        return inside;
    }

    /// The flat pieces of the surface.
    template <class S>
    [[nodiscard]] std::vector<Facet<dim>> facets_of(const S& shape, const std::vector<char>& inside) const {
        Index cells = nodes_;
        for (int& n : cells)
            --n;
        std::vector<std::vector<Facet<dim>>> of_slice(static_cast<std::size_t>(cells[dim - 1]));
        for_slices(cells, [&](const Index& cell, int slice) {
            std::array<bool, static_cast<std::size_t>(corners)> in;
            int number = 0;
            for (int c = 0; c < corners; ++c)
                number += (in[static_cast<std::size_t>(c)] = inside[flat(corner(cell, c))] != 0);
            if (number == 0 || number == corners)
                return;
            // Intersections of the lines between the corners of this cell with the surface, each computed when first
            // needed.
            std::array<Point<dim>, lines> through;
            std::array<bool, lines> known{};
            const auto crossing = [&](int from, int to) -> const Point<dim>& {
                const auto line = static_cast<std::size_t>(from * corners + to);
                if (!known[line]) {
                    known[line] = true;
                    through[line] = crossing_of(shape, place(corner(cell, from)), place(corner(cell, to)));
                }
                return through[line];
            };
            std::array<int, static_cast<std::size_t>(dim)> axes;
            for (int axis = 0; axis < dim; ++axis)
                axes[slot(axis)] = axis;
            do { // a simplex for each order of the axes (Kuhn): from corner to corner along one after the other
                std::array<int, static_cast<std::size_t>(dim + 1)> in_here, out_here;
                int ins = 0, outs = 0, c = 0;
                for (int k = 0; k <= dim; ++k) {
                    (in[static_cast<std::size_t>(c)] ? in_here[slot(ins++)] : out_here[slot(outs++)]) = c;
                    if (k < dim)
                        c |= 1 << axes[slot(k)];
                }
                if (ins == 0 || outs == 0)
                    continue;
                auto& facets = of_slice[static_cast<std::size_t>(slice)];
                if constexpr (dim == 2) {
                    if (ins == 1)
                        facets.push_back({crossing(in_here[0], out_here[0]), crossing(in_here[0], out_here[1])});
                    else
                        facets.push_back({crossing(in_here[0], out_here[0]), crossing(in_here[1], out_here[0])});
                } else {
                    if (ins == 1)
                        facets.push_back({crossing(in_here[0], out_here[0]), crossing(in_here[0], out_here[1]),
                                          crossing(in_here[0], out_here[2])});
                    else if (outs == 1)
                        facets.push_back({crossing(in_here[0], out_here[0]), crossing(in_here[1], out_here[0]),
                                          crossing(in_here[2], out_here[0])});
                    else { // two and two: a piece with four corners
                        const Point<dim> a = crossing(in_here[0], out_here[0]), b = crossing(in_here[0], out_here[1]),
                                         c2 = crossing(in_here[1], out_here[1]), d = crossing(in_here[1], out_here[0]);
                        facets.push_back({a, b, c2});
                        facets.push_back({a, c2, d});
                    }
                }
            } while (std::next_permutation(axes.begin(), axes.end()));
        });
        std::vector<Facet<dim>> all;
        for (const auto& facets : of_slice)
            all.insert(all.end(), facets.begin(), facets.end());
        return all;
    }
    [[nodiscard]] static Index corner(Index cell, int number) {
        for (int axis = 0; axis < dim; ++axis)
            cell[slot(axis)] += number >> axis & 1;
        return cell;
    }
    template <class S>
    [[nodiscard]] static Point<dim> crossing_of(const S& shape, Point<dim> in, Point<dim> out) {
        for (int k = 0; k < 12; ++k) {
            const Point<dim> middle = 0.5 * (in + out);
            (shape.contains(middle) ? in : out) = middle;
        }
        return 0.5 * (in + out);
    }

    /// The shape's own volume, or that of the cells, with those at the surface counted in small parts.
    template <class S>
    [[nodiscard]] double volume_of(const S& shape) const {
        if constexpr (requires { shape.volume(); }) {
            return shape.volume();
        } else {
            Index cells = nodes_;
            for (int& n : cells)
                --n;
            constexpr int parts = dim == 2 ? 8 : 3;
            Index all;
            all.fill(parts);
            std::vector<std::int64_t> hits(static_cast<std::size_t>(cells[dim - 1]));
            for_slices(cells, [&](const Index& cell, int slice) {
                int in = 0, settled = 0;
                for (int c = 0; c < corners; ++c) {
                    const double away = static_cast<double>(values_[flat(corner(cell, c))]);
                    in += away < 0 ? 1 : 0;
                    settled += std::abs(away) > cell_ * std::sqrt(double(dim)) ? 1 : 0;
                }
                auto& sum = hits[static_cast<std::size_t>(slice)];
                if (settled == corners)
                    return void(sum += in == corners ? (dim == 2 ? parts * parts : parts * parts * parts) : 0);
                for_all(Index{}, all, [&](const Index& part) {
                    Point<dim> x = place(cell);
                    for (int axis = 0; axis < dim; ++axis)
                        x[axis] += (part[slot(axis)] + 0.5) / parts * cell_;
                    bool inside = false;
                    if constexpr (ShapeWithDistance<S>)
                        inside = (*this)(x) < 0; // less work than contains() of a mesh
                    else
                        inside = shape.contains(x);
                    sum += inside ? 1 : 0;
                });
            });
            std::int64_t sum = 0;
            for (const auto n : hits)
                sum += n;
            return static_cast<double>(sum) * std::pow(cell_ / parts, dim);
        }
    }

    [[nodiscard]] double value(const Point<dim>& point, Point<dim>* gradient) const {
        Index node;
        Point<dim> part;
        for (int axis = 0; axis < dim; ++axis) {
            const double at = (point[axis] - lower_[axis]) / cell_;
            if (!(at >= 0 && at <= nodes_[slot(axis)] - 1)) { // beyond the grid
                if (gradient != nullptr)
                    gradient->setZero();
                return band_;
            }
            node[slot(axis)] = std::min(static_cast<int>(at), nodes_[slot(axis)] - 2);
            part[axis] = at - node[slot(axis)];
        }
        double sum = 0;
        Point<dim> slope = Point<dim>::Zero();
        for (int c = 0; c < corners; ++c) {
            const double v = static_cast<double>(values_[flat(corner(node, c))]);
            double weight = 1;
            for (int axis = 0; axis < dim; ++axis)
                weight *= c >> axis & 1 ? part[axis] : 1 - part[axis];
            sum += weight * v;
            for (int axis = 0; axis < dim; ++axis) {
                double w = (c >> axis & 1 ? v : -v) / cell_;
                for (int other = 0; other < dim; ++other)
                    if (other != axis)
                        w *= c >> other & 1 ? part[other] : 1 - part[other];
                slope[axis] += w;
            }
        }
        if (gradient != nullptr)
            *gradient = slope;
        return sum;
    }

    double cell_, band_;
    int threads_;
    Point<dim> lower_;
    Index nodes_;
    std::vector<float> values_;
    double volume_ = 0;
};

} // namespace imbibe
