// A random open-cell foam: a box minus randomly placed, overlapping balls (discs in 2D).
#pragma once

#include <imbibe/geometry/passage.hpp>
#include <imbibe/geometry/sampling.hpp>
#include <imbibe/geometry/sphere.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace imbibe {

/// The parameters of a random foam.
struct Foam {
    double pore_radius = 0;   ///< mean radius of the balls, m
    double porosity = 0.8;    ///< open part of the box, 0 to 1
    double radius_spread = 0; ///< radii lie within pore_radius (1 -+ spread), evenly distributed; 0 to 0.9
    std::uint64_t seed = 1;   ///< another seed is another foam; the same seed is the same foam everywhere
};

/// A box minus balls dropped at random until the porosity is reached; then all radii are shrunk together, by less than
/// one ball's worth, to meet it within 0.01. Where two balls overlap, a window joins their pores.
///
/// In 3D the pores connect from a porosity of about 0.3 on, and the solid falls apart near 0.97 (overlapping balls);
/// small loose pieces of solid are possible before. In 2D solid and pores cannot both be connected.
template <int dim>
class RandomFoam {
public:
    /// Throws Error if the radius is not finite and > 0 m or larger than half the shortest side of the box, the
    /// porosity is not between 0.05 and 0.95, the spread not in [0, 0.9], or more than 20000 balls would be needed.
    RandomFoam(const Box<dim>& box, const Foam& foam) : box_{box}, foam_{foam} {
        require(box.bounded(), "RandomFoam: the box must be bounded. Give two corners.");
        detail::require_positive("RandomFoam", "pore_radius", foam.pore_radius, "Give the radius in metres.");
        require(2 * foam.pore_radius <= box.size().minCoeff(), "RandomFoam: pore_radius = ", foam.pore_radius,
                " m; a pore must fit into the box, whose shortest side is ", box.size().minCoeff(),
                " m. Take a smaller radius.");
        require(foam.porosity >= 0.05 && foam.porosity <= 0.95, "RandomFoam: porosity = ", foam.porosity,
                " (no unit) must be from 0.05 to 0.95. Beyond, use the Box itself, or no foam.");
        require(foam.radius_spread >= 0 && foam.radius_spread <= 0.9,
                "RandomFoam: radius_spread = ", foam.radius_spread,
                " (no unit) must be from 0 to 0.9. It is a part of the mean radius.");
        drop_balls();
        index_balls();
    }

    [[nodiscard]] const Foam& foam() const { return foam_; }                       ///< as requested
    [[nodiscard]] const std::vector<Sphere<dim>>& pores() const { return balls_; } ///< the balls, some centres outside

    /// The open part of the box, 0 to 1, measured on samples other than those the radii were fitted to.
    [[nodiscard]] double porosity() const {
        std::size_t open = 0;
        for (std::size_t i = 0; i < samples; ++i)
            open += in_pore(even_point(box_, samples + i)) ? 1u : 0u;
        return static_cast<double>(open) / static_cast<double>(samples);
    }

    /// Diameter (m) of the largest ball that passes through the foam along its last axis; 0 if there is no way through.
    /// Accurate to an eighth of the pore radius, or as 3e7 cells allow for a foam of many pores.
    [[nodiscard]] double pore_width() const {
        const double affordable = std::pow(box_.volume() / 3e7, 1.0 / dim);
        return widest_passage(*this, dim - 1, std::max(foam_.pore_radius / 16, affordable));
    }

    /// Diameters (m) of the windows inside the box: one for each pair of overlapping balls, the circle in which their
    /// surfaces intersect (a chord in 2D), unless its centre lies in a third ball, so that the window has no real rim.
    [[nodiscard]] std::vector<double> windows() const {
        std::vector<double> result;
        for (std::size_t i = 0; i < balls_.size(); ++i)
            for (std::size_t j = i + 1; j < balls_.size(); ++j) {
                const Point<dim> line = balls_[j].centre() - balls_[i].centre();
                const double d = line.norm();
                const double a = balls_[i].radius();
                const double b = balls_[j].radius();
                if (d >= a + b || d <= std::abs(a - b))
                    continue;
                const double along = (d * d + a * a - b * b) / (2 * d);
                const Point<dim> centre = balls_[i].centre() + line * (along / d);
                if (box_.contains(centre) && !in_pore(centre, i, j))
                    result.push_back(2 * std::sqrt(a * a - along * along));
            }
        return result;
    }

    /// Diameter (m) of the smallest window; 0 if there is none. In a random foam some pair of balls always just
    /// touches, so this is small. Whether water passes depends on pore_width().
    [[nodiscard]] double smallest_window() const {
        const std::vector<double> all = windows();
        return all.empty() ? 0.0 : *std::min_element(all.begin(), all.end());
    }

    /// Whether the point is in a ball.
    [[nodiscard]] bool in_pore(const Point<dim>& point) const { return in_pore(point, nobody, nobody); }

    /// Whether the point is in the solid part.
    [[nodiscard]] bool contains(const Point<dim>& point) const { return box_.contains(point) && !in_pore(point); }

    /// The box.
    [[nodiscard]] Box<dim> bounds() const { return box_; }

private:
    static constexpr std::size_t samples = 1u << 15;
    static constexpr std::size_t most_balls = 20000;
    static constexpr std::size_t nobody = ~std::size_t{0};

    /// Places balls until they cover the requested share of the samples, then fits the common factor of the radii.
    void drop_balls() {
        const double largest = foam_.pore_radius * (1 + foam_.radius_spread);
        const Box<dim> wide{box_.lower() - Point<dim>::Constant(largest), // so that the edges are as open as the middle
                            box_.upper() + Point<dim>::Constant(largest)};
        // Overlapping balls leave exp(-n v / V) of the space uncovered, which gives the number needed.
        const double expected =
            -std::log(1 - foam_.porosity) * wide.volume() / Sphere<dim>{Point<dim>::Zero(), foam_.pore_radius}.volume();
        const auto require_few = [&](double n) {
            require(n < most_balls, "RandomFoam: about ", n, " pores of radius ", foam_.pore_radius,
                    " m are needed for a porosity of ", foam_.porosity, "; at most ", most_balls,
                    " are allowed. Take larger pores or a smaller box.");
        };
        require_few(expected);
        std::vector<Point<dim>> places(samples);
        for (std::size_t i = 0; i < samples; ++i)
            places[i] = even_point(box_, i);
        std::vector<double> nearest(samples, std::numeric_limits<double>::max()); // min over balls of distance/radius
        const auto wanted = static_cast<std::size_t>(foam_.porosity * static_cast<double>(samples));
        for (std::size_t covered = 0; covered <= wanted;) {
            const std::size_t n = balls_.size();
            require_few(static_cast<double>(n));
            Point<dim> centre;
            for (int axis = 0; axis < dim; ++axis)
                centre[axis] = wide.lower()[axis] +
                               wide.size()[axis] * random_number(foam_.seed, n, static_cast<std::uint64_t>(axis));
            const double spread = foam_.radius_spread * (2 * random_number(foam_.seed, n, dim) - 1);
            balls_.emplace_back(centre, foam_.pore_radius * (1 + spread));
            covered = 0;
            for (std::size_t i = 0; i < samples; ++i) {
                nearest[i] = std::min(nearest[i], (places[i] - centre).norm() / balls_.back().radius());
                covered += nearest[i] < 1 ? 1u : 0u;
            }
        }
        const double factor = detail::level_of(nearest, foam_.porosity);
        for (auto& ball : balls_)
            ball = Sphere<dim>{ball.centre(), factor * ball.radius()};
    }

    /// Sorts the balls into cells, so that a point is compared only with the few near it.
    void index_balls() {
        double largest = 0;
        for (const auto& ball : balls_)
            largest = std::max(largest, ball.radius());
        std::size_t total = 1;
        for (int axis = 0; axis < dim; ++axis) {
            const double n = std::clamp(std::floor(box_.size()[axis] / largest), 1.0, 64.0);
            cells_[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(n);
            total *= cells_[static_cast<std::size_t>(axis)];
        }
        near_.resize(total);
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            const auto box = balls_[i].bounds();
            const auto from = cell_of(box.lower());
            const auto to = cell_of(box.upper());
            auto cell = from;
            for (;;) {
                near_[flat(cell)].push_back(i);
                std::size_t axis = 0;
                while (axis < dim && ++cell[axis] > to[axis]) {
                    cell[axis] = from[axis];
                    ++axis;
                }
                if (axis == dim)
                    break;
            }
        }
    }

    [[nodiscard]] std::array<std::size_t, static_cast<std::size_t>(dim)> cell_of(const Point<dim>& point) const {
        std::array<std::size_t, static_cast<std::size_t>(dim)> result;
        for (int axis = 0; axis < dim; ++axis) {
            const auto slot = static_cast<std::size_t>(axis);
            const double n = static_cast<double>(cells_[slot]);
            const double place = (point[axis] - box_.lower()[axis]) / box_.size()[axis] * n;
            result[slot] = static_cast<std::size_t>(std::clamp(place, 0.0, n - 1));
        }
        return result;
    }

    [[nodiscard]] std::size_t flat(const std::array<std::size_t, static_cast<std::size_t>(dim)>& cell) const {
        std::size_t result = 0;
        for (std::size_t axis = dim; axis-- > 0;)
            result = result * cells_[axis] + cell[axis];
        return result;
    }

    /// Whether the point is in a ball other than the two named.
    [[nodiscard]] bool in_pore(const Point<dim>& point, std::size_t skip, std::size_t skip_too) const {
        for (const std::size_t i : near_[flat(cell_of(point))])
            if (i != skip && i != skip_too &&
                (point - balls_[i].centre()).squaredNorm() < balls_[i].radius() * balls_[i].radius())
                return true;
        return false;
    }

    Box<dim> box_;
    Foam foam_;
    std::vector<Sphere<dim>> balls_;
    std::array<std::size_t, static_cast<std::size_t>(dim)> cells_{};
    std::vector<std::vector<std::size_t>> near_; // for each cell the balls that reach into it
};

} // namespace imbibe
