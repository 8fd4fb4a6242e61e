// A shape moved, turned or enlarged.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <cmath>

namespace imbibe {

/// A shape seen through p -> turn * (p - about) * factor + about + shift. Made by translated(), rotated(), scaled().
template <AnyShape S>
class Transformed {
public:
    /// 2 or 3.
    static constexpr int dim = shape_dimension<S>;
    /// A rotation.
    using Matrix = Eigen::Matrix<double, dim, dim, Eigen::DontAlign>;

    /// The shape turned by the rotation matrix `turn`, enlarged by `factor` about `about` and moved by `shift` (m).
    Transformed(const S& shape, const Matrix& turn, double factor, const Point<dim>& about, const Point<dim>& shift)
        : shape_{shape}, turn_{turn}, factor_{factor}, about_{about}, shift_{shift} {}

    /// Whether the shape contains the point's place before the transformation.
    [[nodiscard]] bool contains(const Point<dim>& point) const { return shape_.contains(before(point)); }
    /// Distance to the surface, m, negative inside; for a shape that has one.
    [[nodiscard]] double distance(const Point<dim>& point) const requires requires(const S& shape) {
        shape.distance(Point<dim>{});
    }
    { return factor_ * shape_.distance(before(point)); }

    /// The box round the transformed corners of the shape's box: tight for boxes, not for a turned ball.
    [[nodiscard]] Box<dim> bounds() const {
        const Box<dim> box = shape_.bounds();
        if (turn_ == Matrix::Identity() && box.bounded())
            return Box<dim>{image(box.lower()), image(box.upper())};
        if (!box.bounded()) // a bound at infinity times a zero of the matrix is NaN
            return Box<dim>::everywhere();
        Point<dim> lower = image(box.lower());
        Point<dim> upper = lower;
        for (unsigned corner = 1; corner < (1u << dim); ++corner) {
            Point<dim> place = box.lower();
            for (int axis = 0; axis < dim; ++axis)
                if (corner >> axis & 1u)
                    place[axis] = box.upper()[axis];
            lower = lower.cwiseMin(image(place)).eval();
            upper = upper.cwiseMax(image(place)).eval();
        }
        return Box<dim>{lower, upper};
    }

    /// Volume, m^dim, for a shape that has one.
    [[nodiscard]] double volume() const requires requires(const S& shape) { shape.volume(); }
    { return std::pow(factor_, dim) * shape_.volume(); }
    [[nodiscard]] const S& shape() const { return shape_; } ///< the shape before the transformation
    [[nodiscard]] double factor() const { return factor_; } ///< enlargement
    /// The image of a point (m) of the shape.
    [[nodiscard]] Point<dim> image(const Point<dim>& point) const {
        return about_ + turn_ * (point - about_) * factor_ + shift_;
    }

private:
    [[nodiscard]] Point<dim> before(const Point<dim>& point) const {
        return about_ + turn_.transpose() * (point - about_ - shift_) / factor_;
    }

    S shape_;
    Matrix turn_;
    double factor_;
    Point<dim> about_;
    Point<dim> shift_;
};

namespace detail {
template <class S>
inline constexpr bool is_transformed = false;
template <class S>
inline constexpr bool is_transformed<Transformed<S>> = true;
} // namespace detail

/// The shape moved by `shift` (m). Throws Error unless it is finite.
template <AnyShape S>
[[nodiscard]] Transformed<S> translated(const S& shape, const Point<shape_dimension<S>>& shift) {
    constexpr int dim = shape_dimension<S>;
    detail::require_finite<dim>("translated", "shift", shift);
    return {shape, Transformed<S>::Matrix::Identity(), 1.0, Point<dim>::Zero(), shift};
}

/// The 2D shape turned anticlockwise by `angle` (radian) about a point (m). Throws Error unless all is finite.
template <AnyShape S>
requires(shape_dimension<S> == 2)
    [[nodiscard]] Transformed<S> rotated(const S& shape, double angle, const Point<2>& about = Point<2>::Zero()) {
    require(std::isfinite(angle), "rotated: angle = ", angle, " rad must be finite. Give the angle in radians.");
    detail::require_finite<2>("rotated", "about", about);
    const double c = std::cos(angle), s = std::sin(angle);
    typename Transformed<S>::Matrix turn;
    turn << c, -s, s, c;
    return {shape, turn, 1.0, about, Point<2>::Zero()};
}

/// The 3D shape turned by `angle` (radian, right hand) round the line through `about` (m) along `axis`.
/// Throws Error unless all is finite and the axis not zero.
template <AnyShape S>
requires(shape_dimension<S> == 3)
    [[nodiscard]] Transformed<S> rotated(const S& shape, double angle, const Point<3>& axis,
                                         const Point<3>& about = Point<3>::Zero()) {
    require(std::isfinite(angle), "rotated: angle = ", angle, " rad must be finite. Give the angle in radians.");
    detail::require_finite<3>("rotated", "axis", axis);
    detail::require_finite<3>("rotated", "about", about);
    require(!axis.isZero(0), "rotated: axis = ", point_text<3>(axis),
            " must not be zero. Give any vector along the axis of rotation.");
    // Rodrigues: c 1 + (1 - c) n n^T + s [n]x. Eigen's AngleAxis is in a header that includes its decompositions.
    const Point<3> n = axis.stableNormalized(), across = std::sin(angle) * n;
    typename Transformed<S>::Matrix turn = (1 - std::cos(angle)) * n * n.transpose();
    turn.diagonal().array() += std::cos(angle);
    turn(0, 1) -= across[2], turn(1, 0) += across[2];
    turn(0, 2) += across[1], turn(2, 0) -= across[1];
    turn(1, 2) -= across[0], turn(2, 1) += across[0];
    return {shape, turn, 1.0, about, Point<3>::Zero()};
}

/// The shape enlarged by `factor` (1) about a point (m). Throws Error unless the factor is finite and > 0.
template <AnyShape S>
[[nodiscard]] Transformed<S> scaled(const S& shape, double factor,
                                    const Point<shape_dimension<S>>& about = Point<shape_dimension<S>>::Zero()) {
    constexpr int dim = shape_dimension<S>;
    require(std::isfinite(factor) && factor > 0, "scaled: factor = ", factor,
            " (no unit) must be finite and > 0. 0.5 halves every length, 1e-3 turns millimetres into metres.");
    detail::require_finite<dim>("scaled", "about", about);
    return {shape, Transformed<S>::Matrix::Identity(), factor, about, Point<dim>::Zero()};
}

} // namespace imbibe
