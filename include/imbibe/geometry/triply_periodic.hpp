// Sponges bounded by a triply periodic surface: the gyroid and Schwarz' P surface, cut to a box.
#pragma once

#include <imbibe/geometry/passage.hpp>
#include <imbibe/geometry/sampling.hpp>

#include <cmath>
#include <numbers>

namespace imbibe {

/// The surface that divides solid and pore; X, Y, Z are 2 pi times the coordinates in cells.
enum class PeriodicSurface {
    gyroid,   ///< f = sin X cos Y + sin Y cos Z + sin Z cos X (Schoen 1970)
    schwarz_p ///< f = cos X + cos Y + cos Z (Schwarz 1890)
};

/// Which side of the surface is solid.
enum class SolidForm {
    network, ///< f <= t: struts; solid and pore are one connected space each
    sheet    ///< |f| <= t: a curved wall between two separate pore spaces
};

/// The parameters of such a sponge.
struct PeriodicSponge {
    PeriodicSurface surface = PeriodicSurface::gyroid; ///< the surface
    double cell = 0;                                   ///< edge of the repeating cube, m
    double solid_fraction = 0.5;                       ///< solid part of the box, 0 to 1
    SolidForm form = SolidForm::network;               ///< struts or walls
};

/// A box filled with a triply periodic sponge whose cells start in the box's lower corner. The level t is fitted to
/// evenly spread samples of f over this box, so that the solid fraction is met within 0.01, for whole cells or not.
/// (The fraction of particles may differ by a few hundredths: if a cell is a small whole number of spacings, the
/// lattice samples all cells at the same places.)
class TriplyPeriodic {
public:
    /// Throws Error if the cell is not finite and > 0 m or longer than a side of the box, or if with this fraction
    /// the pores close or the solid falls into separate pieces. The message gives the possible range (about 0.21 to
    /// 0.79 for Schwarz P and 0.02 to 0.98 for the gyroid as networks).
    TriplyPeriodic(const Box<3>& box, const PeriodicSponge& sponge) : box_{box}, sponge_{sponge} {
        require(box.bounded(), "TriplyPeriodic: the box must be bounded. Give two corners.");
        detail::require_positive("TriplyPeriodic", "cell", sponge.cell, "Give the edge of a cell in metres.");
        require(sponge.cell <= box.size().minCoeff() * (1 + 1e-9), "TriplyPeriodic: cell = ", sponge.cell,
                " m is longer than the shortest side of the box, ", box.size().minCoeff(),
                " m. Take a smaller cell or a larger box.");
        std::vector<double> values(samples);
        double low = 0;  // share of the box below the least level at which the solid is connected
        double high = 0; // share of the box below the largest level at which the pores are connected
        const double pinched = sponge.surface == PeriodicSurface::gyroid ? std::numbers::sqrt2 : 1.0;
        for (std::size_t i = 0; i < samples; ++i) {
            values[i] = depth(even_point(box, i));
            low += sponge.form == SolidForm::network && values[i] < -pinched ? 1.0 : 0.0;
            high += values[i] < pinched ? 1.0 : 0.0;
        }
        low /= static_cast<double>(samples);
        high /= static_cast<double>(samples);
        require(sponge.solid_fraction > low && sponge.solid_fraction < high,
                "TriplyPeriodic: solid_fraction = ", sponge.solid_fraction, " (no unit) must be between ", low, " and ",
                high,
                ": below, the solid falls to pieces; above, the pores close. Take a fraction within, "
                "or the other surface or form.");
        level_ = detail::level_of(values, sponge.solid_fraction);
    }

    [[nodiscard]] const PeriodicSponge& sponge() const { return sponge_; } ///< as requested
    [[nodiscard]] double level() const { return level_; }                  ///< t in f <= t or |f| <= t

    /// The open part of the box, 0 to 1, measured on samples other than those the level was fitted to.
    [[nodiscard]] double porosity() const {
        std::size_t open = 0;
        for (std::size_t i = 0; i < samples; ++i)
            open += depth(even_point(box_, samples + i)) > level_ ? 1u : 0u;
        return static_cast<double>(open) / static_cast<double>(samples);
    }

    /// Diameter (m) of the largest ball that passes from cell to cell, accurate to 1/32 of a cell.
    [[nodiscard]] double pore_width() const {
        const Point<3> corner = box_.lower();
        TriplyPeriodic piece = *this;
        piece.box_ = Box<3>{corner, corner + 2 * sponge_.cell * Point<3>::Ones()};
        return widest_passage(piece, 2, sponge_.cell / 64);
    }

    /// Whether the point is in the solid part.
    [[nodiscard]] bool contains(const Point<3>& point) const { return box_.contains(point) && depth(point) <= level_; }

    /// The box.
    [[nodiscard]] Box<3> bounds() const { return box_; }

private:
    static constexpr std::size_t samples = 1u << 16;

    /// f or |f| at a point: what is compared with the level.
    [[nodiscard]] double depth(const Point<3>& point) const {
        const Point<3> phase = (point - box_.lower()) * (2 * std::numbers::pi / sponge_.cell);
        const double X = phase[0], Y = phase[1], Z = phase[2];
        const double f = sponge_.surface == PeriodicSurface::gyroid
                             ? std::sin(X) * std::cos(Y) + std::sin(Y) * std::cos(Z) + std::sin(Z) * std::cos(X)
                             : std::cos(X) + std::cos(Y) + std::cos(Z);
        return sponge_.form == SolidForm::sheet ? std::abs(f) : f;
    }

    Box<3> box_;
    PeriodicSponge sponge_;
    double level_ = 0;
};

/// A box of gyroid sponge: cell edge (m) and solid fraction. Throws Error as TriplyPeriodic does.
[[nodiscard]] inline TriplyPeriodic gyroid(const Box<3>& box, double cell, double solid_fraction) {
    return {box, {.surface = PeriodicSurface::gyroid, .cell = cell, .solid_fraction = solid_fraction}};
}

/// A box of Schwarz P sponge: cell edge (m) and solid fraction. Throws Error as TriplyPeriodic does.
[[nodiscard]] inline TriplyPeriodic schwarz_p(const Box<3>& box, double cell, double solid_fraction) {
    return {box, {.surface = PeriodicSurface::schwarz_p, .cell = cell, .solid_fraction = solid_fraction}};
}

} // namespace imbibe
