// The value of a field at a place: a gauge of pressure, a profile of velocities.
#pragma once

#include <imbibe/core/vector.hpp>
#include <imbibe/geometry/point.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solver/solver.hpp>

#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

namespace imbibe {

namespace detail {
// The offset from a place to a particle's stored position, m: to its nearest image.
template <class Scene, class Position>
Point<Scene::dimension> offset_from(const Point<Scene::dimension>& place, const Position& stored, const Scene& scene) {
    const Settings<Scene::dimension>& settings = scene.settings();
    Point<Scene::dimension> off = stored.transpose().template cast<double>() - place;
    for (int d = 0; d < Scene::dimension; ++d) {
        const auto axis = static_cast<std::size_t>(d);
        off[d] += settings.origin[axis];
        if (const double length = settings.periodic_length[axis]; length > 0)
            off[d] -= length * std::round(off[d] / length);
    }
    return off;
}
} // namespace detail

/// A field of a phase at a place, in the field's unit: `value_at(scene, water, pressure, {0.8, 0.02})`.
///
/// From the particles nearer than `support`, with weights w_b = W_ab of Wendland's C2, by moving least squares of first
/// order: the value at `place` of the linear function that fits best,
///
///     f = mean f + g . (place - mean x),  g = (sum_b w_b y_b y_b)^-1 sum_b w_b y_b f_b,  y_b = x_b - mean x,
///
/// with means weighted by w_b. It is exact for fields that are linear in space, also if all particles are on one side:
/// at a wall it gives the pressure at the wall's surface, not that of the first row of water. It exceeds the values
/// around it by at most their range. Where the particles lie on a line, or are too few for a slope, it is the mean
/// (Shepard 1968).
///
/// Not for the pressure on a wall in an impact. It is the pressure within the water nearby, also if that is a drop or a
/// tongue thinner than the support, which loads little of the wall; in the first blow it is many times the wall's load.
/// There use `patch_pressure` or a `WallGauge` (monitor/wall_gauge.hpp): the force on a patch of the wall over its
/// area.
///
/// It reads every particle of the phase: use it for a few gauges in every tenth step, not for pictures. Fields that a
/// step computes, such as the pressure, are 0 before the first step.
///
/// @param scene the scene, @param which the phase, as `scene.add` returned it, @param field the field
/// @param place where, m
/// @param support the kernel's support, m; 0: the support radius of the phase
/// @param dry the result if no particle is near; NaN by default
/// @return a number for a field of numbers, else an Eigen column of its components
/// @throws Error for a support that is negative or not finite
///
/// Source: Lancaster and Salkauskas (1981); as a gauge in particle methods, Dilts (1999).
template <class Scene, class P, class F>
auto value_at(const Scene& scene, PhaseHandle<P> which, F field, const Point<Scene::dimension>& place,
              double support = 0, double dry = std::numeric_limits<double>::quiet_NaN()) {
    constexpr int dim = Scene::dimension;
    const auto phase = scene[which];
    const auto x = phase[position];
    const auto f = phase[field];
    using Value = Eigen::Matrix<double, std::remove_cvref_t<decltype(f)>::ColsAtCompileTime, 1>;
    require(std::isfinite(support) && support >= 0, "value_at: a support of ", support,
            " m; it must be above 0 m, or 0 for that of the phase");
    const double H = support > 0 ? support : phase.material().support_radius;

    struct Near {
        double weight;
        Point<dim> offset; // (x_b - place)/H, x_b being the nearest one of its images
        Value value;
    };
    std::vector<Near> around;
    for (int i = 0; i < phase.size(); ++i) {
        const Point<dim> off = detail::offset_from(place, x.row(i), scene);
        if (const double q = off.norm() / H; q < 1)
            around.push_back({WendlandC2::value(q), off / H, f.row(i).transpose().template cast<double>()});
    }

    Value value = Value::Constant(dry);
    if (!around.empty()) {
        double weights = 0;
        Point<dim> middle = Point<dim>::Zero();
        Value mean = Value::Zero(), low = around.front().value, high = low;
        for (const Near& b : around) {
            weights += b.weight;
            middle += b.weight * b.offset;
            mean += b.weight * b.value;
            low = low.cwiseMin(b.value);
            high = high.cwiseMax(b.value);
        }
        middle /= weights;
        mean /= weights;
        auto spread = Tensor<double, dim>::zero(); // sum w y y
        Eigen::Matrix<double, Value::RowsAtCompileTime, dim> along;
        along.setZero();
        for (const Near& b : around) {
            const Point<dim> y = b.offset - middle;
            spread = spread + b.weight * outer(from_eigen<double, dim>(y), from_eigen<double, dim>(y));
            along += b.weight * b.value * y.transpose();
        }
        value = mean;
        if (determinant(spread) > 1e-3 * power<dim>(trace(spread) / dim)) // they are spread in all directions
            value -= along * to_eigen(inverse(spread) * from_eigen<double, dim>(middle));
        const Value range = high - low;
        value = value.cwiseMax(low - range).cwiseMin(high + range);
    }
    if constexpr (Value::RowsAtCompileTime == 1)
        return value[0];
    else
        return value;
}

} // namespace imbibe
