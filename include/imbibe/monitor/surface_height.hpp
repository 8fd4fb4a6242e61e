// The height of a fluid's surface at a place: a wave gauge.
#pragma once

#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/value_at.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace imbibe {

/// The height of a fluid's surface at a place, m: `surface_height(scene, water, {0.8, 0})`. Up is against gravity, so
/// the result is y at the surface if gravity points along -y. The component of `place` along that direction does not
/// matter.
///
/// Along the line through `place` the particles fill a share of space,
///
///     s = sum_b (m_b/rho_b) W_b,
///
/// with Wendland's C2. s is near 1 within the fluid, 1/2 at a level surface, and half of both along a wall. The surface
/// is the highest point where s is half of its greatest value on the line, or 1/2 if that value is above 1; s is linear
/// between points a quarter of a spacing apart. For particles on a lattice a level surface is right to a fiftieth of a
/// spacing.
///
/// Where waves break, the result is the highest surface; drops above the fluid do not count if s stays below half of
/// that within it. If s is nowhere above a fifth there is no fluid, only drops. It reads every particle of the phase:
/// use it for a few gauges in every tenth step.
///
/// @param scene the scene, with gravity, @param which the phase, as `scene.add` returned it
/// @param place a point of the line, m
/// @param support the kernel's support, m; 0: the support radius of the phase, but at least 3 spacings
/// @param dry the result without fluid; NaN by default
/// @throws Error for a support that is negative or not finite, without gravity, and where the scene is periodic upwards
///
/// Source: the threshold of half a mass is that of the gauges of DualSPHysics (Crespo et al. 2015); taking it from the
/// line, for gauges at walls, is own.
template <class Scene, class P>
double surface_height(const Scene& scene, PhaseHandle<P> which, const Point<Scene::dimension>& place,
                      double support = 0, double dry = std::numeric_limits<double>::quiet_NaN()) {
    constexpr int dim = Scene::dimension;
    const Settings<dim>& settings = scene.settings();
    const Point<dim> gravity = Eigen::Map<const Point<dim>>(settings.gravity.data());
    require(gravity.norm() > 0, "surface_height: the scene has no gravity, so nothing says which way is up");
    const Point<dim> up = -gravity.normalized();
    for (int d = 0; d < dim; ++d) {
        const double length = settings.periodic_length[static_cast<std::size_t>(d)];
        require(!(length > 0) || up[d] == 0, "surface_height: the scene is periodic along axis ", d, " (", length,
                " m), along which gravity acts; there is no highest point");
    }
    require(std::isfinite(support) && support >= 0, "surface_height: a support of ", support,
            " m; it must be above 0 m, or 0 for that of the phase");
    const auto phase = scene[which];
    const double spacing = phase.material().spacing;
    const double H = support > 0 ? support : std::max<double>(phase.material().support_radius, 3 * spacing);

    struct Near {
        double above, aside2, volume; // m over `place`, squared m beside the line, m^dim
    };
    std::vector<Near> around;
    const auto x = phase[position];
    const auto m = phase[mass], rho = phase[density];
    double top = -std::numeric_limits<double>::infinity(), bottom = -top;
    for (int i = 0; i < phase.size(); ++i) {
        const Point<dim> off = detail::offset_from(place, x.row(i), scene);
        const double above = up.dot(off), aside2 = (off - above * up).squaredNorm();
        if (aside2 < H * H) {
            around.push_back({above, aside2, static_cast<double>(m(i)) / static_cast<double>(rho(i))});
            top = std::max(top, above + H);
            bottom = std::min(bottom, above);
        }
    }
    if (around.empty())
        return dry;

    const double step = 0.25 * spacing;
    std::vector<double> share(static_cast<std::size_t>((top - bottom) / step) + 2, 0.0); // from the top downwards
    for (const Near& b : around) {
        const double reach = std::sqrt(H * H - b.aside2);
        const double first = std::max(std::ceil((top - b.above - reach) / step), 0.0);
        for (auto k = static_cast<std::size_t>(first); k < share.size(); ++k) {
            const double along = top - static_cast<double>(k) * step - b.above;
            if (along < -reach)
                break;
            share[k] += b.volume * kernel_value<WendlandC2, dim>(std::sqrt(sq(along) + b.aside2), H);
        }
    }
    const double greatest = *std::max_element(share.begin(), share.end());
    if (greatest < 0.2)
        return dry;
    const double half = 0.5 * std::min(greatest, 1.0);
    std::size_t k = 0;
    while (share[k] < half)
        ++k;
    // The share is 0 at the top, where k = 0.
    const double before = share[k - 1], down = static_cast<double>(k - 1) + (half - before) / (share[k] - before);
    return up.dot(place) + top - down * step;
}

} // namespace imbibe
