// The width of the narrowest pore, slot or gap of a body, by the present positions of its particles.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/search/neighbour_search.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace imbibe {

/// A place where a body's surface faces itself.
template <int dim>
struct Passage {
    double width;                         ///< m, between faces half a spacing outside their particles
    Eigen::Matrix<double, dim, 1> middle; ///< m
};

namespace detail {

/// The support over which the normal of a surface particle is summed, in spacings.
inline constexpr double normal_support = 2.2;

/// The search distance for passages up to `widest`, m: a period must be at least as long.
inline double reach_of_passages(double spacing, double widest) {
    return std::max(widest + spacing, normal_support * spacing);
}

} // namespace detail

/// The narrowest passage among the particles of a body, if one is narrower than `widest`.
///
/// At a particle a of the surface, the width of a passage is the diameter of the ball that touches the surface there
/// and at a second particle b across, 2R = |x_b - x_a|^2/(n_a . (x_b - x_a)), less one spacing (Ma, Bae and Choi 2012,
/// The Visual Computer 28, 7-19: the ball of the medial axis). The normal n_a is the direction of the sum of (x_a -
/// x_b)(1 - r/H)^2 over particles nearer than H = 2.2 spacings. Both a and b must face each other within 30 degrees, so
/// that edges and corners of a hollow are no passages. Accurate to a spacing of the body where a lattice forms a round
/// pore.
///
/// Not for single layers of particles, which have no normal, nor for faces nearer than 0.4 spacings, which have lost
/// theirs: neither is found. Not for particles that lie off their lattice by more than a tenth of a spacing: inner
/// particles may then look like a surface, and give false pores.
///
/// Costs two searches, one of them over surface particles only.
/// @param x positions, n rows and dim columns, m; views of a scene's positions fit
/// @param spacing between the particles, m
/// @param widest wider passages are not looked for, m
/// @param periodic periodic sides, none unless given
/// @param threads 0: all of the machine
/// @throws Error for a spacing or width that is not a finite number above 0, a position that is not finite, and a period
/// that is shorter than 2.2 spacings or than `widest` and a spacing
template <int dim, class Real>
std::optional<Passage<dim>> narrowest_passage(const typename search::NeighbourSearch<dim, Real>::Positions& x,
                                              double spacing, double widest, const search::Periodic<dim>& periodic = {},
                                              int threads = 0) {
    require(spacing > 0 && std::isfinite(spacing), "narrowest_passage: spacing = ", spacing,
            " m; it must be a finite number above 0 m, the distance of the body's particles");
    require(widest > 0 && std::isfinite(widest), "narrowest_passage: widest = ", widest,
            " m; it must be a finite number above 0 m, usually that of 1 to 4 particles");
    using Vector = Eigen::Matrix<double, dim, 1>;
    // Relative to a particle whose neighbours are all in one direction. On a lattice 0.30 (3D) and 0.44 (2D) at a face,
    // below 0.01 in the layer under it.
    constexpr double at_surface = 0.12, facing = 0.866;

    const double support = detail::normal_support * spacing;
    search::NeighbourSearch<dim, Real> neighbours(support, periodic, threads);
    neighbours.add(x);
    neighbours.update();
    std::vector<Vector> normals;
    std::vector<Eigen::Index> surface;
    for (int a = 0; a < neighbours.size(0); ++a) {
        Vector sum = Vector::Zero();
        double most = 0;
        neighbours.for_each(0, a, [&](int, const auto& offset, Real distance) {
            const auto r = static_cast<double>(distance);
            const double weight = (1 - r / support) * (1 - r / support);
            sum += weight * offset.template cast<double>();
            most += weight * r;
        });
        if (sum.norm() > at_surface * most) {
            normals.push_back(sum.normalized());
            surface.push_back(a);
        }
    }

    Eigen::Matrix<Real, Eigen::Dynamic, dim> faces(static_cast<Eigen::Index>(surface.size()), dim);
    for (std::size_t k = 0; k < surface.size(); ++k)
        faces.row(static_cast<Eigen::Index>(k)) = x.row(surface[k]);
    search::NeighbourSearch<dim, Real> across(widest + spacing, periodic, threads);
    across.add(faces);
    across.update();
    std::optional<Passage<dim>> least;
    for (int a = 0; a < across.size(0); ++a)
        across.for_each(0, a, [&](int b, const auto& offset, Real distance) {
            const auto r = static_cast<double>(distance);
            const Vector to_b = -offset.template cast<double>();
            const double out = normals[static_cast<std::size_t>(a)].dot(to_b);
            const double back = -normals[static_cast<std::size_t>(b)].dot(to_b);
            if (out < facing * r || back < facing * r)
                return;
            const double width = r * r / out - spacing;
            if (width < widest && (!least || width < least->width))
                least = {width, faces.row(a).transpose().template cast<double>() + 0.5 * to_b};
        });
    return least;
}

} // namespace imbibe
