// The sponge scene with convergent schemes: the water of sound_water.hpp and a total-Lagrangian solid.
#pragma once

#include <imbibe/methods/total_lagrangian_solid.hpp>
#include <imbibe/presets/sound_water.hpp>
#include <imbibe/presets/sponge_case.hpp>
#include <imbibe/solid/clamped.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/time/subcycled.hpp>

namespace imbibe::presets {

/// The scene of the paper with schemes that converge. The sponge is coupled to `SoundWater` like the walls (Adami, Hu
/// and Adams 2012) instead of by K_f, which remains as a guard over less than a spacing. It is a total-Lagrangian
/// neo-Hookean solid with corrected gradients and hourglass control. Sound speed: ten times the speed of the fall. The
/// sponge has a support of its own, 2 spacings: with 2.6 a plate of ten layers swings 5 % too slowly, and costs twice
/// as much. Its Young's modulus is corrected for its few layers (bending_modulus). It takes short steps of its own, so
/// that its spacing, which is finer than the water's, does not make those of the water short.
struct SoundSponge : SoundWater {
    static constexpr const char* name = "sound";
    struct Sponge : Solid<TotalLagrangianSolid<CompressibleNeoHookean, K>, TotalLagrangianViscosity<K>, Clamped,
                          TimeAveragedMotion> {};
    /// Takes its coefficients from set_coefficients(), as Water and Sides.
    struct Contact : Coupling<Water, Sponge, Into<Sponge, PressureExtrapolation<K>>, VolumePressure<K>,
                              Into<Water, VolumeContinuity<K>>, KernelRepulsion<Spiky>> {};

    /// The scene.
    template <class Real>
    using Scene = Solver<3, Real, Subcycled<Sponge>, Water, Sponge, Vessel, Contact, Sides>;

    /// Throws Error for a number of the case that is out of range, a Poisson's ratio above that of its law included.
    static void check(const SpongeCase& c) {
        c.check();
        require(c.poisson_ratio <= CompressibleNeoHookean::greatest_poisson_ratio,
                "Poisson's ratio = ", c.poisson_ratio, "; it must be above -1 and at most ",
                CompressibleNeoHookean::greatest_poisson_ratio, ", above which the mean ",
                "stress of CompressibleNeoHookean alternates from particle to particle; a scene of your own with ",
                "VolumetricDeviatoric in its place goes to 0.499");
    }
    /// The sponge with the numbers of the case.
    /// @throws Error as check()
    static Sponge sponge(const SpongeCase& c) {
        check(c);
        const double young = bending_modulus(c.young_modulus, static_cast<int>(std::lround(c.solid_layers())));
        return {{.density = 950,
                 .sound_speed = sound_speed_of(young, c.poisson_ratio, 950),
                 .shear_modulus = shear_modulus_of(young, c.poisson_ratio),
                 .support_radius = c.solid_support_ratio * c.solid_spacing}};
    }

    /// The scene with its particles. Throws Error for a number of the case that is out of range.
    template <class Real>
    static Scene<Real> make(SpongeCase c) {
        return make<SoundSponge, Real>(c);
    }
    /// The same with phases and couplings of another composition, which derives from this one.
    template <class Composition, class Real>
    static auto make(SpongeCase c) {
        check(c);
        if (c.search_interval == 0) // fast drops make it 2; displacements stay within 0.5 % of their peak
            c.search_interval = 4;
        const double reach = c.support_ratio * c.water_spacing, sound_speed = 10 * c.fall_speed();
        typename Composition::template Scene<Real> scene(c.settings(reach));
        typename Composition::Water water{{.density = 1000, .sound_speed = sound_speed, .viscosity = c.viscosity}};
        set_coefficients(water);
        scene.add(water, c.water(), c.water_spacing);
        const auto slab = scene.add(sponge(c), c.sponge(), c.solid_spacing);
        scene.hold(slab, [&](const Point<3>& x) { return c.clamped(x); });
        scene.add(Vessel{{.density = 1000}}, c.vessel(reach), c.water_spacing);
        set_coefficients(scene.template coupling<typename Composition::Contact>(), water);
        set_coefficients(scene.template coupling<typename Composition::Sides>(), water);
        return scene;
    }
};

} // namespace imbibe::presets

/// The parts of `SoundSponge::Scene<Real>` that take long to compile (compiled_scene.hpp).
#define IMBIBE_SOUND_SPONGE_FUNCTIONS(linkage, Real)                                                                   \
    IMBIBE_SCENE_FUNCTIONS(linkage,                                                                                    \
                           imbibe::Solver<3, Real, imbibe::Subcycled<imbibe::presets::SoundSponge::Sponge>,            \
                                          imbibe::presets::SoundSponge::Water, imbibe::presets::SoundSponge::Sponge,   \
                                          imbibe::presets::SoundSponge::Vessel, imbibe::presets::SoundSponge::Contact, \
                                          imbibe::presets::SoundSponge::Sides>);                                       \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::SoundSponge::Water, imbibe::presets::SoundSponge::Scene<Real>);   \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::SoundSponge::Sponge, imbibe::presets::SoundSponge::Scene<Real>);  \
    IMBIBE_PHASE_FUNCTIONS(linkage, imbibe::presets::SoundSponge::Vessel, imbibe::presets::SoundSponge::Scene<Real>)

#ifdef IMBIBE_COMPILED_PRESETS
#include <imbibe/presets/compiled_scene.hpp>
IMBIBE_SOUND_SPONGE_FUNCTIONS(extern, float);
IMBIBE_SOUND_SPONGE_FUNCTIONS(extern, double);
#endif
