// The pressure on a patch of wall, as a sensor measures it: force over area.
#pragma once

#include <imbibe/geometry/tank.hpp>
#include <imbibe/monitor/value_at.hpp>
#include <imbibe/wall/reaction_force.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <vector>

namespace imbibe {

/// A patch of the surface of a wall: a rectangle normal to an axis, in 2D a line segment. `WallPatch<2>{{1.6, 0}, {1.6,
/// 0.05}, Sides::x_high}` is the lowest 50 mm of the end wall of a tank 1.6 m long.
template <int dim>
struct WallPatch {
    /// Two corners of the rectangle, m: the lesser coordinates and the greater ones. Along the axis normal to the wall
    /// both are at its surface, half a spacing before its first particles.
    Point<dim> lower, upper;
    /// The side of the water on which the wall is, one only, named as for tank(): the wall `Sides::x_high` is where x
    /// is greater than at its surface.
    Sides side;

    /// The axis normal to the wall: 0 for x.
    int axis() const {
        int axis = 0;
        while (axis < dim - 1 && !includes(side, axis, 0) && !includes(side, axis, 1))
            ++axis;
        return axis;
    }
    /// m^2 (m in 2D).
    double area() const {
        double product = 1;
        for (int d = 0; d < dim; ++d)
            if (d != axis())
                product *= upper[d] - lower[d];
        return product;
    }
    /// Throws Error unless it is a rectangle normal to the axis of its side. @param where what the message begins with
    void check(std::string_view where) const {
        bool one = false; // exactly one side, which exists in this dimension
        for (int d = 0; d < dim; ++d)
            for (int end = 0; end < 2; ++end)
                one = one || static_cast<unsigned>(side) == 1u << (2 * d + end);
        require(one, where, ": a patch lies on one side of the water; name one, such as Sides::x_high, across x or y",
                dim == 3 ? " or z" : "");
        require(lower.allFinite() && upper.allFinite(), where, ": the corners of the patch, ", point_text<dim>(lower),
                " and ", point_text<dim>(upper), ", must be finite");
        for (int d = 0; d < dim; ++d)
            require(d == axis() ? upper[d] == lower[d] : upper[d] > lower[d], where, ": the patch from ",
                    point_text<dim>(lower), " to ", point_text<dim>(upper), " is on a wall across ", "xyz"[axis()],
                    d == axis() ? ", so both corners have the same " : ", so the second corner has a greater ",
                    "xyz"[d]);
    }
};

/// The pressure on a patch of wall, Pa: the force of the water on the wall's particles behind the patch, along the
/// normal, over the area of the patch; positive where the water presses. `patch_pressure(scene, patch, tank)`.
///
///     p = sum_a w_a n.F_a / A,  F_a = `reaction_force` of particle a, n into the wall,
///
/// over the particles at most a support behind the plane of the patch. w_a is the share of the particle's own square, a
/// spacing wide, that the patch covers: so the patch need not fit the particles, and the forces of adjacent patches add
/// up exactly to that on the wall. Where the wall meets another one, as at the foot of a tank, the water also pushes on
/// particles beyond the edge, behind both walls: their force is mirrored at the edge and counted.
///
/// It is what a pressure sensor of that area measures, and the pressure to use in an impact. Water thinner than the
/// support shows its own pressure all around (`value_at`, PressureExtrapolation), but pushes on little of the wall;
/// only the force shows that.
///
/// The coupling must list ReactionForce of the terms that push: `Into<Tank, ReactionForce<VolumePressure<K>>>`. The
/// force is that at the begin of the last step, and 0 before the first one. The spatial resolution is about a support:
/// narrower patches are no sharper. For a sensor's response in time see WallGauge. It reads every particle of the wall.
///
/// Only for walls normal to an axis. Not for a sheet thinner than a support that is wet on both sides: there it is the
/// difference of the two pressures.
///
/// @param scene the scene, @param patch where
/// @param walls the phases that the wall is made of, as `scene.add` returned them: the wall and, where it stands on
/// another one, as a box on the floor, that too
/// @throws Error for a patch that is no rectangle, and where less than half of the patch has a wall behind it
///
/// Source: the definition; that the force of the pairs is that of the pressure on the surface, Adami, Hu and Adams
/// (2012).
template <class Scene, class... Wall>
double patch_pressure(const Scene& scene, const WallPatch<Scene::dimension>& patch, PhaseHandle<Wall>... walls) {
    static_assert(sizeof...(Wall) > 0, "imbibe: patch_pressure(scene, patch, wall): which phase is the wall?");
    constexpr int dim = Scene::dimension;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    patch.check("patch_pressure");
    const int across = patch.axis();
    const double outwards = includes(patch.side, across, 1) ? 1 : -1; // along the axis, into the wall
    const Point<dim> middle = 0.5 * (patch.lower + patch.upper), half = 0.5 * (patch.upper - patch.lower);

    // Particles less than a support from the plane of the patch, and beside it by at most the distance of mirroring.
    struct Near {
        Point<dim> offset;             // from the middle of the patch, m
        double behind, spacing, force; // m and m; N along the normal
    };
    std::vector<Near> around;
    const auto collect = [&](const auto& view) {
        const auto x = view[position];
        const auto pushed = view[reaction_force];
        const double reach = std::max<double>(view.material().support_radius, scene.settings().support_radius);
        for (int i = 0; i < view.size(); ++i) {
            const Point<dim> off = detail::offset_from(middle, x.row(i), scene);
            if (std::abs(off[across]) < reach && ((off.cwiseAbs() - half).array() < 2 * reach).all())
                around.push_back({off, outwards * off[across], view.material().spacing,
                                  outwards * static_cast<double>(pushed(i, across))});
        }
    };
    (collect(scene[walls]), ...);

    // Where other walls begin, from the middle, m: those with particles before the patch's plane, next to it.
    Point<dim> least = Point<dim>::Constant(-infinity), greatest = Point<dim>::Constant(infinity);
    for (const Near& a : around) {
        const double before = -a.behind;
        for (int d = 0; d < dim; ++d) {
            if (d == across || !(before > 0) || before >= a.spacing)
                continue;
            bool beside = true; // along the other axis, if there is one, it is where the patch is
            for (int other = 0; other < dim; ++other)
                beside = beside && (other == d || other == across || std::abs(a.offset[other]) < half[other]);
            if (beside && a.offset[d] < 0)
                least[d] = std::max(least[d], a.offset[d] + 0.5 * a.spacing);
            else if (beside)
                greatest[d] = std::min(greatest[d], a.offset[d] - 0.5 * a.spacing);
        }
    }

    double force = 0, covered = 0;
    for (const Near& a : around) {
        if (!(a.behind > 0))
            continue;
        double share = 1;
        bool mirrored = false;
        for (int d = 0; d < dim; ++d) {
            if (d == across)
                continue;
            double at = a.offset[d];
            if (at < least[d] || at > greatest[d]) {
                at = 2 * (at < least[d] ? least[d] : greatest[d]) - at;
                mirrored = true;
            }
            const double from = std::max(at - 0.5 * a.spacing, -half[d]), to = std::min(at + 0.5 * a.spacing, half[d]);
            share *= std::max(to - from, 0.0) / a.spacing;
        }
        force += share * a.force;
        if (!mirrored && a.behind < a.spacing)
            covered += share * power<dim - 1>(a.spacing);
    }
    if (covered < 0.5 * patch.area()) {
        double least2 = infinity;
        Point<dim> nearest = middle;
        const auto look_for_nearest = [&](const auto& view) {
            const auto x = view[position];
            for (int i = 0; i < view.size(); ++i)
                if (const Point<dim> off = detail::offset_from(middle, x.row(i), scene); off.squaredNorm() < least2) {
                    least2 = off.squaredNorm();
                    nearest = middle + off;
                }
        };
        (look_for_nearest(scene[walls]), ...);
        throw Error(text("patch_pressure: the wall covers ", 100 * covered / patch.area(), " % of the patch from ",
                         point_text<dim>(patch.lower), " to ", point_text<dim>(patch.upper),
                         ", with particles less than a spacing behind it; ",
                         std::isfinite(least2) ? "the nearest particle of the wall is at " + point_text<dim>(nearest)
                                               : std::string("the wall has no particles"),
                         ". At least half must be covered: put the patch on the wall's surface, half a spacing before ",
                         "its first particles, and name the side on which the wall is, as seen from the water."));
    }
    return force / patch.area();
}

/// A pressure sensor in a wall: the mean of patch_pressure over the last `window` seconds.
///
///     WallGauge<2> gauge({{1.6, 0}, {1.6, 0.05}, Sides::x_high}, 1e-3);
///     scene.run_until(1, [&](const Scene& now) { table.row({now.time(), gauge(now, tank)}); });
///
/// Call it after every step; each step counts with its length, so the impulse of a blow is right for any window. That
/// is the response of an integrating sensor: it follows changes slower than the window, shows no faster sound, and
/// shows blows of length t < window lower by t/window. Weakly compressible water rings with the sound speed of the
/// scene, not with that of water, and the shorter the window, the more of the reading is that ringing: sound runs up
/// and down a depth h in 4 h/c, and a window of a few times that leaves the flow. A record sampled at a rate f is
/// comparable with a window of at least 1/f.
template <int dim>
class WallGauge {
public:
    /// @param patch where, @param window how long, s; 0: the last step alone
    /// @throws Error for a patch that is no rectangle, and a window that is negative or not finite
    explicit WallGauge(const WallPatch<dim>& patch, double window = 0) : patch_(patch), window_(window) {
        patch.check("WallGauge");
        require(std::isfinite(window) && window >= 0, "WallGauge: a window of ", window,
                " s; it must be finite and at least 0 s, which is the last step alone");
    }

    /// Adds the last step and returns the gauge's value, Pa. In a run shorter than the window it is the mean from the
    /// first call on. It starts anew if the scene has gone back in time.
    template <class Scene, class... Wall>
    double operator()(const Scene& scene, PhaseHandle<Wall>... walls) {
        const double now = scene.time(), pressure = patch_pressure(scene, patch_, walls...);
        if (!past_.empty() && now < past_.back().time)
            past_.clear();
        if (past_.empty())
            past_.push_back({now, 0});
        else if (const double step = now - past_.back().time; step > 0)
            past_.push_back({now, past_.back().impulse + step * pressure});
        while (past_.size() > 2 && past_[1].time <= now - window_)
            past_.pop_front();
        if (window_ == 0 || past_.size() == 1)
            return shown_ = pressure;
        // The window begins within the first of the remaining steps, or before it.
        const Sum &first = past_[0], &second = past_[1];
        const double begin = std::max(now - window_, first.time);
        const double before =
            first.impulse + (second.impulse - first.impulse) * (begin - first.time) / (second.time - first.time);
        return shown_ = (past_.back().impulse - before) / (now - begin);
    }

    /// The value of the last call, Pa.
    double pressure() const { return shown_; }
    /// Where it is.
    const WallPatch<dim>& patch() const { return patch_; }

private:
    struct Sum {
        double time, impulse; // s, and Pa s since the first call
    };
    WallPatch<dim> patch_;
    double window_, shown_ = 0;
    std::deque<Sum> past_;
};

} // namespace imbibe
