// Fills shapes with particles whose outer layers follow the surface, and surrounds shapes with such layers.
#pragma once

#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/level_set.hpp>
#include <imbibe/geometry/sampling.hpp>
#include <imbibe/geometry/transform.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/search/neighbour_search.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace imbibe {

/// Settings of the packing along a surface. The defaults are for everyday use.
struct Fitting {
    int steps = 100; ///< of the relaxation, 0 to 10000
    int threads = 0; ///< 1 to 1024; 0: all of the machine. The particles are the same for any number
};

namespace detail {

/// The support of the relaxation's kernel, and the depth on both sides of a surface in which particles move, in
/// spacings.
inline constexpr double fitting_reach = 2.6, fitting_depth = 2.6;

/// Moves the particles with the numbers `moving` down the gradient of sum_b W_ab, `steps` times; keep(i, x) returns the
/// final position of particle i for the new position x.
template <int dim, class Keep>
void relax(std::vector<Point<dim>>& points, const std::vector<int>& moving, double spacing, int steps, int threads,
           const Keep& keep) {
    const double H = fitting_reach * spacing, skin = 0.4 * spacing, close = 0.6 * spacing;
    Point<dim> aside; // two particles in one place move apart along it
    for (int axis = 0; axis < dim; ++axis)
        aside[axis] = std::cos(1.0 + axis);
    const double share = std::pow(spacing / H, dim) * WendlandC2::normalisation<dim>();
    const auto number = static_cast<int>(moving.size());
    search::NeighbourSearch<dim, double> search(H + skin, {}, threads);
    Eigen::Matrix<double, Eigen::Dynamic, dim> places(static_cast<Eigen::Index>(points.size()), dim);
    search.add(places);
    std::vector<std::vector<int>> neighbours(moving.size());
    std::vector<Point<dim>> next(moving.size()), listed_at(moving.size());
    double factor = 0.125; // C/4
    for (int step = 0; step < steps; ++step, factor *= 0.995) {
        double farthest = step == 0 ? skin : 0;
        for (std::size_t m = 0; step > 0 && m < moving.size(); ++m)
            farthest = std::max(farthest, (points[static_cast<std::size_t>(moving[m])] - listed_at[m]).norm());
        if (2 * farthest >= skin) { // a pair may have come nearer than the lists know
            for (std::size_t i = 0; i < points.size(); ++i)
                places.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
            search.move(0, places);
            search.update();
        }
        parallel_blocks(number, 256, threads, [&](int begin, int end) {
            for (auto m = static_cast<std::size_t>(begin); m < static_cast<std::size_t>(end); ++m) {
                const int i = moving[m];
                const Point<dim> x = points[static_cast<std::size_t>(i)];
                auto& list = neighbours[m];
                if (2 * farthest >= skin) {
                    list.clear();
                    search.for_each(0, i, [&](int j, const auto&, double) { list.push_back(j); });
                    listed_at[m] = x;
                }
                Point<dim> push = Point<dim>::Zero(), apart = push;
                for (const int j : list) {
                    const Point<dim> offset = x - points[static_cast<std::size_t>(j)];
                    const double q2 = offset.squaredNorm() / (H * H);
                    if (q2 < 1)
                        push -= WendlandC2::derivative_over_q(std::sqrt(q2)) * offset;
                    // The slope of a kernel vanishes at its centre: a pair that a corner has brought together would
                    // stay together.
                    if (const double r = H * std::sqrt(q2); r < close)
                        apart += 0.25 * (close - r) * (offset + 1e-6 * (i < j ? close : -close) * aside) /
                                 (r + 1e-6 * close);
                }
                push = factor * share * push + apart;
                const double length = push.norm(), most = 0.2 * spacing;
                next[m] = keep(i, x + (length > most ? most / length : 1.0) * push);
            }
        });
        for (std::size_t m = 0; m < moving.size(); ++m)
            points[static_cast<std::size_t>(moving[m])] = next[m];
    }
}

/// Packs the particles of several regions and of their surroundings together: one list per region, and the
/// surroundings, up to `layers` spacings from the nearest region, as the last.
///
/// All start on one lattice, so that no place is filled twice or left open. A region gets the round(volume/spacing^dim)
/// particles that lie deepest in it; all the others are surroundings. Particles nearer to a surface than 2.6 spacings
/// then move down the gradient of sum_b W_ab, Fitting::steps times,
///
///     x_a -= C/4 H^2 sum_b spacing^dim grad_a W_ab,   C = 0.5 * 0.995^step, at most 0.2 spacings,
///
/// with the kernel WendlandC2 over H = 2.6 spacings. Pairs nearer than 0.6 spacings move apart by half of the
/// shortfall. Particles less than half a spacing from a surface are moved back to that distance, on their own side.
/// Particles further away stay on the lattice and hold the others.
///
/// Source: Zhu, Zhang and Hu (2021) for the relaxation with a bounding by level set, Neher et al. (2026) for the
/// packing of both sides together.
template <int dim>
std::vector<std::vector<Point<dim>>> pack(const char* who, const std::vector<LevelSet<dim>>& regions,
                                          const Box<dim>& bounds, double spacing, const Point<dim>& anchor, int layers,
                                          const Fitting& fitting) {
    require(fitting.steps >= 0 && fitting.steps <= 10000, who, ": Fitting::steps = ", fitting.steps,
            " must be from 0 to 10000; 100 is usual.");
    require(fitting.threads >= 0 && fitting.threads <= most_threads, who, ": Fitting::threads = ", fitting.threads,
            " must be from 1 to ", most_threads, ", or 0 for all of the machine.");
    const int threads = fitting.threads > 0 ? fitting.threads : available_threads();
    const double margin = (std::max<double>(layers, fitting_depth + fitting_reach) + 1) * spacing;
    const Box<dim> wide{bounds.lower() - Point<dim>::Constant(margin), bounds.upper() + Point<dim>::Constant(margin)};
    const auto surroundings = static_cast<int>(regions.size());
    const auto of = [&](int region) -> const LevelSet<dim>& { return regions[static_cast<std::size_t>(region)]; };
    std::vector<Point<dim>> points = lattice_points<dim>(who, wide, spacing, anchor, 0.5, [&](const Point<dim>& x) {
        return std::any_of(regions.begin(), regions.end(), [&](const auto& s) { return s(x) < s.band(); });
    });
    const auto number = points.size();

    // Each region gets the particles that lie deepest in it. Ties, as of a whole layer, are broken at random, not by
    // position.
    std::vector<int> owner(number, surroundings);
    std::vector<std::pair<double, std::uint64_t>> depths;
    for (int region = 0; region < surroundings; ++region) {
        depths.clear();
        const auto key = [&](std::size_t i) {
            const double tie = random_number(1, i) * 1e-4 * spacing;
            return std::pair{of(region)(points[i]) + tie, i};
        };
        for (std::size_t i = 0; i < number; ++i)
            if (owner[i] == surroundings)
                depths.push_back(key(i));
        require(of(region).volume() >= 0.5 * std::pow(spacing, dim), who, ": the shape has a volume of ",
                of(region).volume(), " m^", dim, "; that is less than half a particle of spacing ", spacing,
                " m. Take a smaller spacing, or check that both are in metres.");
        const auto wanted = static_cast<std::size_t>(std::llround(of(region).volume() / std::pow(spacing, dim)));
        const auto enough = depths.begin() + static_cast<std::ptrdiff_t>(std::min(wanted, depths.size()));
        std::nth_element(depths.begin(), enough, depths.end());
        for (auto it = depths.begin(); it != enough; ++it)
            owner[it->second] = region;
    }

    std::vector<int> moving; // near a surface
    for (std::size_t i = 0; i < number; ++i)
        if (std::any_of(regions.begin(), regions.end(),
                        [&](const auto& s) { return std::abs(s(points[i])) < fitting_depth * spacing; }))
            moving.push_back(static_cast<int>(i));

    relax(points, moving, spacing, fitting.steps, threads, [&](int i, const Point<dim>& x) {
        Point<dim> normal, kept = x;
        for (int region = 0; region < surroundings; ++region) {
            const double sign = region == owner[static_cast<std::size_t>(i)] ? -1 : 1;
            const double beyond = 0.5 * spacing - sign * of(region)(kept, normal);
            if (beyond > 0 && normal.squaredNorm() > 0.05)
                kept += sign * beyond / std::max(normal.squaredNorm(), 0.25) * normal;
        }
        return kept;
    });

    std::vector<std::vector<Point<dim>>> result(regions.size() + 1);
    for (std::size_t i = 0; i < number; ++i) {
        const auto belongs = static_cast<std::size_t>(owner[i]);
        if (owner[i] < surroundings ||
            std::any_of(regions.begin(), regions.end(), [&](const auto& s) { return s(points[i]) < layers * spacing; }))
            result[belongs].push_back(points[i]);
    }
    return result;
}

/// The level sets of some shapes, and pack() with them.
template <int dim, AnyShape... S>
std::vector<std::vector<Point<dim>>> pack_shapes(const char* who, double spacing, const Point<dim>& anchor, int layers,
                                                 const Fitting& fitting, const S&... shapes) {
    require_positive(who, "spacing", spacing, "Give the distance between particles in metres.");
    const auto require_bounded = [&](const Box<dim>& box) {
        require(box.bounded(), who, ": a shape has no bounds (lower ", point_text<dim>(box.lower()), ", upper ",
                point_text<dim>(box.upper()), "). Intersect it with a box: shape & Box.");
        return box;
    };
    const std::vector<Box<dim>> boxes{require_bounded(shapes.bounds())...};
    require_finite<dim>(who, "anchor", anchor);
    require(layers >= 0 && layers <= 1000, who, ": layers = ", layers,
            " must be from 0 to 1000. As many as the support radius has spacings, rounded up, is usual: 2 to 4.");
    const double band = (std::max<double>(layers, fitting_depth + fitting_reach) + 0.5) * spacing;
    std::vector<LevelSet<dim>> regions;
    regions.reserve(sizeof...(S));
    (regions.emplace_back(shapes, 0.5 * spacing, anchor, band, fitting.threads), ...);
    Box<dim> bounds = boxes[0];
    for (const auto& box : boxes)
        bounds = bounds.joined(box);
    return pack<dim>(who, regions, bounds, spacing, anchor, layers, fitting);
}

/// place(shape, spacing); for a shape that is turned, moved or enlarged the transformed result in the shape's own
/// frame.
template <AnyShape S, class Place>
std::vector<Point<shape_dimension<S>>> in_own_frame(const S& shape, double spacing, const Place& place) {
    if constexpr (is_transformed<S>) {
        auto points = in_own_frame(shape.shape(), spacing / shape.factor(), place);
        for (auto& point : points)
            point = shape.image(point);
        return points;
    } else {
        return place(shape, spacing);
    }
}

} // namespace detail

/// Particle positions (m) that fill a shape and follow its surface: round(volume/spacing^dim) of them, the outermost
/// half a spacing deep. On flat faces along the lattice they are those of fill(). Elsewhere fill() makes stairs, which
/// are too soft as a solid, brake sliding flow as a wall (docs/validation.md, turned-beam and ramp), and give a small
/// body the wrong mass.
///
/// The lattice begins in the lower corner of the shape's bounds. A shape that is turned, moved or enlarged is filled in
/// its own frame first. The same shape gives the same particles, for any number of threads. Parts thinner than a
/// spacing may be missed, and edges are rounded by a fraction of a spacing. A shape that is not a whole number of
/// spacings thick has uneven layers.
///
/// Throws Error as fill() does, and if the shape has less volume than half a particle.
template <AnyShape S>
[[nodiscard]] std::vector<Point<shape_dimension<S>>> fitted(const S& shape, double spacing,
                                                            const Fitting& fitting = {}) {
    return detail::in_own_frame(shape, spacing, [&](const auto& own, double of) {
        return detail::pack_shapes<shape_dimension<S>>("fitted", of, own.bounds().lower(), 0, fitting, own)[0];
    });
}

/// Positions (m) of wall particles that follow the surface of a shape: `layers` layers around it, the first half a
/// spacing outside. `walls_of(shape, spacing, 3)` matches `fitted(shape, spacing)`: both are of one packing. For the
/// walls of a box with open sides see tank(). Throws Error as fitted() does, and for layers < 1.
template <AnyShape S>
[[nodiscard]] std::vector<Point<shape_dimension<S>>> walls_of(const S& shape, double spacing, int layers,
                                                              const Fitting& fitting = {}) {
    require(layers >= 1, "walls_of: layers = ", layers,
            " must be from 1 to 1000. As many as the support radius has spacings, rounded up, is usual: 2 to 4.");
    return detail::in_own_frame(shape, spacing, [&](const auto& own, double of) {
        return detail::pack_shapes<shape_dimension<S>>("walls_of", of, own.bounds().lower(), layers, fitting, own)[1];
    });
}

/// Packs several touching shapes, such as a body and the water around it, together on one lattice, with `layers` layers
/// outside all of them. The lists of their particles (m) come in the order of the shapes, that of the layers last:
///
///     const auto [body, water, walls] = fitted_together(spacing, Point<2>{0, 0}, 3, ball, tank - ball);
///
/// The shapes must not overlap; an overlap belongs to the first one. Throws Error as fitted() does.
/// @param spacing distance of the particles, m
/// @param anchor a corner of the lattice, m
/// @param layers outside; 0: none
/// @param first a shape
/// @param others more of them
template <AnyShape First, AnyShape... Others>
[[nodiscard]] std::array<std::vector<Point<shape_dimension<First>>>, sizeof...(Others) + 2>
fitted_together(double spacing, const Point<shape_dimension<First>>& anchor, int layers, const First& first,
                const Others&... others) {
    auto packed = detail::pack_shapes<shape_dimension<First>>("fitted_together", spacing, anchor, layers, Fitting{},
                                                              first, others...);
    std::array<std::vector<Point<shape_dimension<First>>>, sizeof...(Others) + 2> result;
    std::move(packed.begin(), packed.end(), result.begin());
    return result;
}

} // namespace imbibe
