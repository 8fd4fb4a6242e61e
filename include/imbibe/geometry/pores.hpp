// A slab with a regular array of straight pores: round, square or hexagonal holes in 3D, slots in 2D.
#pragma once

#include <imbibe/geometry/shape.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace imbibe {

/// The cross-section of a pore.
enum class PoreShape {
    circular, ///< a circle
    square,   ///< a square with sides along the axes
    hexagonal ///< a regular hexagon with two corners on the line through its centre along the first cross axis
};

/// The parameters of a regular array of straight pores. Cross axes are those other than `axis`, in ascending order.
template <int dim>
struct Pores {
    std::array<int, static_cast<std::size_t>(dim - 1)> count{}; ///< pores along each cross axis, at least 1
    double pitch = 0;                       ///< distance between the centres of neighbouring pores, m
    double radius = 0;                      ///< half the clear width, m: circle radius, half a side, or apothem
    PoreShape shape = PoreShape::circular;  ///< cross-section; in 2D every pore is a slot
    int axis = dim - 1;                     ///< the pores run along this axis: 0, 1 or 2
    Point<dim> offset = Point<dim>::Zero(); ///< moves the array off the middle of the slab, m
};

/// A box minus an array of straight pores through it, centred in the box except for `offset`. The walls of the pores
/// belong to the solid.
template <int dim>
class PerforatedSlab {
public:
    /// Throws Error if a count is < 1, pitch or radius are not finite and > 0 m, pores touch each other (their width
    /// must be less than the pitch), or a pore reaches over the edge of the slab.
    PerforatedSlab(const Box<dim>& slab, const Pores<dim>& pores) : slab_{slab}, pores_{pores} {
        require(slab.bounded(), "PerforatedSlab: the slab must be bounded. Give two corners.");
        require(pores.axis >= 0 && pores.axis < dim, "PerforatedSlab: axis = ", pores.axis, " must be from 0 to ",
                dim - 1, ".");
        detail::require_positive("PerforatedSlab", "pitch", pores.pitch, "Give the distance of pore centres.");
        detail::require_positive("PerforatedSlab", "radius", pores.radius, "For no pores use the Box itself.");
        detail::require_finite<dim>("PerforatedSlab", "offset", pores.offset);
        for (std::size_t k = 0; k < dim - 1; ++k) {
            const int n = pores.count[k];
            const double half = half_width(k);
            require(n >= 1, "PerforatedSlab: count = ", n, " along cross axis ", k,
                    " must be at least 1. For no pores use the Box itself.");
            require(n == 1 || 2 * half < pores.pitch, "PerforatedSlab: pores ", 2 * half,
                    " m wide run into each other at a pitch of ", pores.pitch,
                    " m; the pitch must be larger. Take a smaller radius or a larger pitch.");
            const double side = slab.size()[cross_axis(k)];
            const double reach = 0.5 * (n - 1) * pores.pitch + half + std::abs(pores.offset[cross_axis(k)]);
            require(reach <= 0.5 * side * (1 + 1e-9), "PerforatedSlab: ", n, " pores of radius ", pores.radius,
                    " m at a pitch of ", pores.pitch, " m reach ", reach, " m from the middle along ",
                    "xyz"[cross_axis(k)], ", over the edge of a slab ", side, " m wide; at most ", 0.5 * side,
                    " m is allowed. Take fewer or smaller pores, or a wider slab.");
        }
    }

    [[nodiscard]] const Box<dim>& slab() const { return slab_; }          ///< the box without its pores
    [[nodiscard]] const Pores<dim>& pores() const { return pores_; }      ///< the array as requested
    [[nodiscard]] double pore_width() const { return 2 * pores_.radius; } ///< clear width of a pore, m

    /// The share of the slab that is pore, 0 to 1 (exact): number of pores times pore cross-section over that of the
    /// slab.
    [[nodiscard]] double porosity() const {
        const double r = pores_.radius;
        double open = 2 * r;
        if constexpr (dim == 3)
            open = r * r *
                   (pores_.shape == PoreShape::circular ? std::numbers::pi
                    : pores_.shape == PoreShape::square ? 4.0
                                                        : 2 * std::numbers::sqrt3);
        double area = 1;
        for (std::size_t k = 0; k < dim - 1; ++k) {
            open *= pores_.count[k];
            area *= slab_.size()[cross_axis(k)];
        }
        return open / area;
    }

    /// Whether the point is in a pore, extended infinitely on both sides of the slab.
    [[nodiscard]] bool in_pore(const Point<dim>& point) const {
        std::array<double, static_cast<std::size_t>(dim - 1)> offset; // from the centre of the nearest pore
        for (std::size_t k = 0; k < dim - 1; ++k) {
            const int axis = cross_axis(k);
            const double last = pores_.count[k] - 1;
            const double first = slab_.centre()[axis] + pores_.offset[axis] - 0.5 * last * pores_.pitch;
            const double nearest = std::clamp(std::round((point[axis] - first) / pores_.pitch), 0.0, last);
            offset[k] = std::abs(point[axis] - first - nearest * pores_.pitch);
        }
        const double r = pores_.radius;
        if constexpr (dim == 2)
            return offset[0] < r;
        else
            switch (pores_.shape) {
            case PoreShape::square:
                return offset[0] < r && offset[1] < r;
            case PoreShape::hexagonal:
                return offset[1] < r && 0.5 * (std::numbers::sqrt3 * offset[0] + offset[1]) < r;
            default:
                return offset[0] * offset[0] + offset[1] * offset[1] < r * r;
            }
    }

    /// Whether the point is in the solid part.
    [[nodiscard]] bool contains(const Point<dim>& point) const { return slab_.contains(point) && !in_pore(point); }

    /// The slab.
    [[nodiscard]] Box<dim> bounds() const { return slab_; }

private:
    /// Cross axis number k: the axes of space except that of the pores.
    [[nodiscard]] int cross_axis(std::size_t k) const {
        const auto axis = static_cast<int>(k);
        return axis < pores_.axis ? axis : axis + 1;
    }

    /// How far a pore reaches from its centre along cross axis k.
    [[nodiscard]] double half_width(std::size_t k) const {
        const bool corner = dim == 3 && pores_.shape == PoreShape::hexagonal && k == 0;
        return corner ? pores_.radius * 2 / std::numbers::sqrt3 : pores_.radius;
    }

    Box<dim> slab_;
    Pores<dim> pores_;
};

} // namespace imbibe
