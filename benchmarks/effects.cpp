// What each effect costs: compositions with an effect and without it, a cube of 8000 particles in motion, 3D, float, a
// support of 2.6 spacings of Wendland's C2, one thread; the loops of a step, without search and motion, which cost
// every composition the same. Walls and couplings are a floor or a slab under a cube of water, three layers thick.
// tools/effects_report.py runs all of it and writes docs/effects.md:
//
//   build-benchmark/benchmarks/effects                    the cases, and what is known of each before it runs
//   build-benchmark/benchmarks/effects CASE               does the work of a case once, for counting instructions
//   build-benchmark/benchmarks/effects --time CASE        prints the time of it, ns per particle
#include "support/block.hpp"
#include "support/measured.hpp"

#include <imbibe/imbibe.hpp>

#include <map>

namespace {

using namespace imbibe;
using K = WendlandC2;

template <class... More>
using WaterWith = Fluid<LinearState, VolumeContinuity<K>, VolumePressure<K>, More...>;
template <class... More>
using RubberWith = Solid<LinearState, Continuity<K>, VelocityGradient<K>, JaumannStress, StressForce<K>, More...>;
template <class... More>
using PlateWith =
    Solid<ReferenceCorrection<K>, DeformationGradient<K>, StVenantKirchhoff, TotalLagrangianForce<K>, More...>;

// Phases are told apart by name.
struct Water : WaterWith<> {};
struct WaterMonaghan : WaterWith<MonaghanViscosity<K>> {};
struct WaterLaminar : WaterWith<LaminarViscosity<>> {};
struct WaterMorris : WaterWith<MorrisViscosity<K>> {};
struct WaterCleary : WaterWith<ClearyViscosity<K>> {};
struct WaterPaste : WaterWith<GeneralisedNewtonianViscosity<Carreau, K>> {};
struct WaterDiffusion : WaterWith<DensityDiffusion<K>> {};
struct WaterFloor : WaterWith<DensityFloor> {};
struct WaterXsph : WaterWith<Xsph<K>, XsphTransport> {};
struct WaterShifting : WaterWith<ParticleShifting<K>> {};
struct WaterAdvection : WaterWith<ParticleShifting<K>, TransportAdvection<K>> {};
struct WaterTait : Fluid<Tait<7>, VolumeContinuity<K>, VolumePressure<K>> {};
struct WaterUnderPressure : Fluid<UnderPressure<LinearState>, VolumeContinuity<K>, VolumePressure<K>> {};
struct WaterSymmetric : Fluid<LinearState, Continuity<K>, SymmetricPressure<K>> {};
struct WaterRiemann : Fluid<LinearState, RiemannContinuity<K>, RiemannPressure<K>> {};
struct WaterSummation : Fluid<LinearState, SummationDensity<K>, VolumePressure<K>> {};
struct WaterSummationFloor : WaterWith<SummationFloor<K>> {};
struct WaterRelaxed : WaterWith<SummationRelaxation<K>> {};
struct WaterTensionless : Fluid<LinearState, VolumeContinuity<K>, VolumePressure<K, Tension::none>> {};
struct WaterCorrected : Fluid<LinearState, CurrentCorrection<K>, CorrectedContinuity<K>, CorrectedPressure<K>> {};
struct WaterSlow
    : Fluid<LinearState, InnerCorrection<K>, CorrectedContinuity<K>, CorrectedPressure<K>, StrainShifting<K>> {};
struct WaterCorrectedViscosity : WaterWith<CurrentCorrection<K>, CorrectedViscosity<K>> {};
struct WaterAntuono : WaterWith<CurrentCorrection<K>, AntuonoDiffusion<K>> {};
struct WaterHeat : WaterWith<HeatCapacity, HeatConduction<K>> {};
struct WaterHeatBuoyant : WaterWith<HeatCapacity, HeatConduction<K>, Boussinesq> {};
struct WaterHeatShifted : WaterWith<ParticleShifting<K>, HeatCapacity, HeatConduction<K>, EnthalpyAdvection<K>> {};
struct WaterIce : WaterWith<Melting, HeatConduction<K>> {};
struct WaterIceAtRest : WaterWith<Melting, HeatConduction<K>, EnthalpyPorosity> {};
struct WaterIceElastic : WaterWith<Melting, HeatConduction<K>, VelocityGradient<K>, FrozenStress<K>> {};
struct Rubber : RubberWith<> {};
struct RubberArtificial : RubberWith<ArtificialStress<K>> {};
struct RubberMonaghan : RubberWith<MonaghanViscosity<K>> {};
struct RubberNormal : RubberWith<SurfaceNormal<K>> {};
struct RubberHughesWinget
    : Solid<LinearState, Continuity<K>, VelocityGradient<K>, HughesWingetStress<>, StressForce<K>> {};
struct RubberCorrected : Solid<LinearState, CurrentCorrection<K>, CorrectedContinuity<K>, CorrectedVelocityGradient<K>,
                               JaumannStress, CorrectedStressForce<K>> {};
struct Plate : PlateWith<> {};
struct PlateHourglass : PlateWith<HourglassControl<K>> {};
struct PlateViscosity : PlateWith<TotalLagrangianViscosity<K>> {};
struct PlateClamped : PlateWith<Clamped> {};
struct PlateCauchy : PlateWith<CauchyStress> {};
struct PlateAveraged : PlateWith<TimeAveragedMotion> {};
struct PlateNeoHookean
    : Solid<ReferenceCorrection<K>, DeformationGradient<K>, CompressibleNeoHookean, TotalLagrangianForce<K>> {};
struct PlateIsochoric
    : Solid<ReferenceCorrection<K>, DeformationGradient<K>, IsochoricNeoHookean, TotalLagrangianForce<K>> {};
struct PlateFinite : Solid<ReferenceCorrection<K>, DeformationGradient<K>, FiniteStrainLimit<StVenantKirchhoff>,
                           TotalLagrangianForce<K>> {};
struct PlateVolumetric
    : Solid<ReferenceCorrection<K>, DeformationGradient<K>, VolumetricDeviatoric<>, TotalLagrangianForce<K>> {};
struct PlatePairwise : Solid<ReferenceCorrection<K>, DeformationGradient<K>, PairwiseShearForce<K>> {};

// What lies under the water, and what is between the two.
struct Floor : Wall<> {};
struct Slab : PlateWith<> {};
struct SlabNormal : PlateWith<ReferenceSurfaceNormal<K>> {};
struct WaterBelow : WaterWith<> {};
struct Drop : WaterWith<InterfaceForce<K>> {};
struct DropBelow : WaterWith<InterfaceForce<K>> {};
struct Cohesive : Fluid<CohesiveFluid> {};
struct CohesiveReading : Fluid<CohesiveFluid, LiquidPressure> {};
struct Warm : WaterWith<Melting, HeatConduction<K>, Boussinesq> {};
struct Seeping : Fluid<InPores<>, SeepingFluid<K>> {};
struct Skeleton : Solid<ReferenceCorrection<K>, DeformationGradient<K>, PorousSkeleton<>, TotalLagrangianForce<K>> {};
struct WarmSeeping : Fluid<InPores<>, SeepingFluid<K>, HeatCapacity, PoreHeatConduction<K>> {};
struct WarmSkeleton : Solid<ReferenceCorrection<K>, DeformationGradient<K>, PorousSkeleton<>, TotalLagrangianForce<K>,
                            HeatCapacity, HeatConduction<K, Reference>> {};
struct HotFloor : Wall<SurfaceTemperature> {};
struct Heater : Wall<HeatFlux> {};
template <class Below, class... Term>
using Contact = Coupling<Water, Below, Term...>;
template <class Above, class Below, class... More>
using ExtrapolationOf = Coupling<Above, Below, Into<Below, PressureExtrapolation<K>>, VolumePressure<K>,
                                 Into<Above, VolumeContinuity<K>>, More...>;
template <class Below, class... More>
using Extrapolation = ExtrapolationOf<Water, Below, More...>;
template <class... More>
using CorrectedExtrapolation =
    ExtrapolationOf<WaterCorrectedViscosity, Floor, Into<WaterCorrectedViscosity, CorrectionNeighbours<K>>, More...>;
template <class Below>
using Riemann =
    Contact<Below, Into<Water, RiemannWallNormal<K>>, RiemannWallPressure<K>, Into<Water, RiemannWallContinuity<K>>>;
struct FloorExtrapolation : Extrapolation<Floor> {};
struct FloorNoSlip : Extrapolation<Floor, Into<Floor, NoSlipVelocity<K>>, NoSlipViscosity<K>> {};
struct FloorLinearNoSlip : Extrapolation<Floor, Into<Floor, LinearNoSlipVelocity<K>>, NoSlipViscosity<K>> {};
struct FloorNoSlipContinuity
    : Contact<Floor, Into<Floor, PressureExtrapolation<K>>, VolumePressure<K>, Into<Water, NoSlipContinuity<K>>,
              Into<Floor, NoSlipVelocity<K>>, NoSlipViscosity<K>> {};
struct FloorLoaded : Extrapolation<Floor, Into<Floor, ReactionForce<VolumePressure<K>>>> {};
struct FloorRiemann : Riemann<Floor> {};
struct FloorRepulsion : Contact<Floor, KernelRepulsion<>> {};
struct CorrectedFloor : CorrectedExtrapolation<> {};
struct CorrectedFloorNoSlip : CorrectedExtrapolation<Into<Floor, NoSlipVelocity<K>>, CorrectedNoSlipViscosity<K>> {};
struct PasteFloor : ExtrapolationOf<WaterPaste, Floor> {};
struct PasteFloorNoSlip : ExtrapolationOf<WaterPaste, Floor, Into<Floor, NoSlipVelocity<K>>,
                                          Into<WaterPaste, NoSlipStrainRate<K>>, NoSlipApparentViscosity<K>> {};
template <class Above, class Below, class... More>
using LayersOf = Coupling<Above, Below, VolumePressure<K>, VolumeContinuity<K>, More...>;
struct Layers : LayersOf<Water, WaterBelow> {};
struct LayersTension : LayersOf<Drop, DropBelow, InterfaceTension<K>, InterfaceForce<K>> {};
struct DropFloor : ExtrapolationOf<Drop, Floor> {};
struct DropFloorAngle : ExtrapolationOf<Drop, Floor, Into<Drop, ContactAngle<K>>, ContactLineForce<K>> {};
struct CohesiveFloor : CouplingOf<Cohesive, Floor> {};
struct WarmFloor : ExtrapolationOf<Warm, Floor> {};
struct WarmFloorBuoyant : ExtrapolationOf<Warm, Floor, Into<Floor, BoussinesqExtrapolation<K>>> {};
struct WarmFloorFrozen : ExtrapolationOf<Warm, Floor, Into<Warm, FrozenDrag<K>>> {};
struct WarmFloorHeated : ExtrapolationOf<Warm, Heater, Into<Warm, HeatFromWalls<K>>> {};
struct WarmFloorHot : ExtrapolationOf<Warm, HotFloor, Into<HotFloor, TemperatureExtrapolation<K>>, HeatTransfer<K>> {};
struct Soaked : CouplingOf<Seeping, Skeleton> {};
struct SoakedWarm : CouplingOf<WarmSeeping, WarmSkeleton, PoreHeatExchange<K>> {};
struct SlabExtrapolation : Extrapolation<Slab> {};
struct SlabRiemann : Riemann<Slab> {};
struct SlabNormals : Contact<SlabNormal, SurfaceNormalPressure<K>, Into<Water, VolumeContinuity<K>>> {};
struct SlabModified : Contact<Slab, ModifiedRepulsion> {};
struct SlabRepulsion : Contact<Slab, KernelRepulsion<>> {};

template <class P>
P material() {
    if constexpr (requires(P p) { p.shear_modulus; }) {
        P solid{{.density = 1000, .sound_speed = 30, .shear_modulus = 3e5}};
        if constexpr (detail::contains<PorousSkeleton<>, typename P::terms>)
            solid.set(PorousSkeletonParameters{.porosity = 0.5});
        if constexpr (detail::contains<HeatCapacity, typename P::terms>)
            solid.set(HeatParameters{.heat_capacity = 1900, .heat_conductivity = 0.15});
        return solid;
    } else {
        P fluid{{.density = 1000, .sound_speed = 30, .viscosity = 1e-3}};
        if constexpr (std::is_same_v<P, WaterRelaxed>)
            fluid.set(SummationRelaxationParameters{.time = 1}); // it has no default
        if constexpr (std::is_same_v<P, WaterPaste>)
            fluid.set(CarreauParameters{.at_rest = 0.056, .fast = 0.00345, .time = 3.313, .exponent = 0.3568}); // blood
        if constexpr (detail::contains<Cohesion, typename P::terms>) {
            fluid.set(CohesionParameters{.surface_tension = 0.072});
            fluid.support_radius = detail::CohesionConstants::support * bench::spacing;
        }
        if constexpr (detail::contains<HeatCapacity, typename P::terms>)
            fluid.set(HeatParameters{.heat_capacity = 4186, .heat_conductivity = 0.6});
        if constexpr (detail::contains<Melting, typename P::terms>) // in mush, where all of it has something to do
            fluid.set(MeltingParameters{4200, 2100, 0.6, 2.2, 3.34e5, 273.15, 100, 273.15 + 100});
        if constexpr (detail::contains<FrozenStress<K>, typename P::terms>)
            fluid.set(FrozenStressParameters{.shear_modulus = 1e5});
        return fluid;
    }
}

constexpr int particles = 8000;
constexpr double support = 2.6; // spacings

/// A cube of one phase.
template <class P>
struct Alone {
    using Costs = imbibe::Costs<Composition<3, P>>;
    static std::string costs() {
        return text(Costs::template bytes<P, float>, " ", Costs::template sweeps<P>, " ", Costs::rounds, " ",
                    Costs::template loads<P, P>);
    }
    static auto prepared() { return bench::block<float>(material<P>(), particles, support); }
};
/// A cube of a fluid on a layer of another phase, with a coupling or none. Costs are those of both phases together.
template <class Above, class Below, class... Between>
struct OnTop {
    using Costs = imbibe::Costs<Composition<3, Above, Below, Between...>>;
    static std::string costs() {
        return text(Costs::template bytes<Above, float> + Costs::template bytes<Below, float>, " ",
                    Costs::template sweeps<Above> + Costs::template sweeps<Below>, " ", Costs::rounds, " ",
                    Costs::template loads<Above, Above> + Costs::template loads<Above, Below> +
                        Costs::template loads<Below, Above> + Costs::template loads<Below, Below>);
    }
    static auto prepared() {
        using bench::spacing;
        Solver<3, float, SymplecticEuler, Above, Below, Between...> scene(
            {.gravity = {0, 0, -9.81}, .support_radius = support * spacing, .threads = 1});
        const double side = std::cbrt(double(particles)) * spacing;
        const auto water = scene.add(material<Above>(), bench::cube(particles), spacing);
        const auto below =
            scene.add(material<Below>(), fill(Box<3>{{0, 0, -3 * spacing}, {side, side, 0}}, spacing), spacing);
        bench::stir(scene[water], spacing);
        if constexpr (Below::moves)
            bench::stir(scene[below], spacing);
        scene.prepare();
        return scene.engine();
    }
};

/// A cube of a fluid in the pores of a skeleton. Costs are those of both phases together.
template <class Liquid, class Body, class Between>
struct Overlap : OnTop<Liquid, Body, Between> {
    static auto prepared() {
        using bench::spacing;
        Solver<3, float, SymplecticEuler, Liquid, Body, Between> scene(
            {.support_radius = support * spacing, .threads = 1});
        const auto liquid = scene.add(material<Liquid>(), bench::cube(particles), spacing);
        const auto body = scene.add(material<Body>(), bench::cube(particles), spacing);
        scene.template coupling<Between>().set(DarcyDragParameters{.permeability = 1e-9});
        bench::stir(scene[liquid], spacing);
        bench::stir(scene[body], spacing);
        fill_pores(scene, liquid, body);
        scene.prepare();
        return scene.engine();
    }
};

template <class Subject>
double count() {
    auto engine = Subject::prepared();
    bench::count([&] { bench::run_loops(engine); });
    return particles;
}
/// The shortest of 30 steps, ns per particle of the cube.
template <class Subject>
double nanoseconds() {
    auto engine = Subject::prepared();
    return 1e9 * bench::shortest_seconds(30, [&] { bench::run_loops(engine); }) / particles;
}

struct Case {
    std::string costs, effect, good_for;
    double (*count)();
    double (*nanoseconds)();
};
using Cases = std::map<std::string, Case>;
/// @tparam Named the phase or coupling that gives the case its name
template <class Named, class Subject = Alone<Named>>
void add(Cases& cases, const char* effect, const char* good_for) {
    cases[detail::type_name<Named>()] = {Subject::costs(), effect, good_for, count<Subject>, nanoseconds<Subject>};
}
template <class Between>
void add_contact(Cases& cases, const char* effect, const char* good_for) {
    add<Between, OnTop<typename Between::First, typename Between::Second, Between>>(cases, effect, good_for);
}

Cases all_cases() {
    Cases cases;
    add<Water>(cases, "the plain fluid: `LinearState`, `VolumeContinuity`, `VolumePressure`",
               "what the rows below are compared with");
    add<WaterMonaghan>(cases, "`MonaghanViscosity`", "damps noise and sound; keeps particles apart in a shock");
    add<WaterLaminar>(cases, "`LaminarViscosity`", "the sponge paper's viscosity");
    add<WaterMorris>(cases, "`MorrisViscosity`", "real viscosity, where channels and boundary layers count");
    add<WaterCleary>(cases, "`ClearyViscosity`", "real viscosity that keeps angular momentum; jumps of viscosity");
    add<WaterPaste>(cases, "`GeneralisedNewtonianViscosity` with `Carreau` (or `HerschelBulkley`)",
                    "liquids that thin, thicken or yield");
    add<WaterDiffusion>(cases, "`DensityDiffusion`", "a smooth pressure");
    add<WaterFloor>(cases, "`DensityFloor`", "splashes: no tension where drops part");
    add<WaterXsph>(cases, "`Xsph` with `XsphTransport`", "particles that move with their neighbours, in order");
    add<WaterShifting>(cases, "`ParticleShifting`, whose sums are `ShiftingNeighbours`",
                       "evenly spread particles where flow stretches them");
    add<WaterAdvection>(cases, "`TransportAdvection` with `ParticleShifting`",
                        "velocities that are right although particles are shifted");
    add<WaterAntuono>(cases, "`AntuonoDiffusion` with `CurrentCorrection`",
                      "a smooth pressure, where gravity is not all that acts");
    add<WaterCorrected>(
        cases,
        "`CorrectedContinuity` and `CorrectedPressure` with `CurrentCorrection` in place of continuity and pressure",
        "waves and vortices that keep their energy");
    add<WaterSlow>(cases,
                   "`CorrectedContinuity`, `CorrectedPressure` and `StrainShifting`, whose sum is "
                   "`ConcentrationNeighbours`, with `InnerCorrection` in place of continuity and pressure",
                   "flow that is slow under a high pressure (the method `CorrectedGradients`)");
    add<WaterCorrectedViscosity>(cases,
                                 "`CorrectedViscosity` with `CurrentCorrection`, whose sums are `CorrectionNeighbours`",
                                 "real viscosity to the last per mille");
    add<WaterRiemann>(cases, "`RiemannContinuity` and `RiemannPressure` in place of continuity and pressure",
                      "impacts");
    add<WaterSummation>(cases, "`SummationDensity` in place of `VolumeContinuity`",
                        "a density that follows from the places alone");
    add<WaterSummationFloor>(cases, "`SummationFloor`, whose sum is `SummationNeighbours`",
                             "water that is compressed where its density does not say so");
    add<WaterRelaxed>(cases, "`SummationRelaxation`, whose sum is `SummationNeighbours`",
                      "densities that do not drift from the places of shifted particles");
    add<WaterTensionless>(cases, "`VolumePressure` with `Tension::none` in place of that without",
                          "water that no wall holds back");
    add<WaterUnderPressure>(cases, "`UnderPressure<LinearState>` in place of `LinearState`",
                            "fluids that fill what they are in and are not to be in tension");
    add<WaterSymmetric>(cases, "`Continuity` and `SymmetricPressure` in place of those of volumes",
                        "the sponge paper's pair, for one fluid");
    add<WaterTait>(cases, "`Tait` in place of `LinearState`", "a liquid that stiffens under pressure");
    add<WaterHeat>(cases, "`HeatCapacity` and `HeatConduction`", "heat, and with a second phase `HeatTransfer`");
    add<WaterHeatBuoyant>(cases, "the same with `Boussinesq`", "convection: what is warm rises");
    add<WaterHeatShifted>(cases, "the same with `ParticleShifting` and `EnthalpyAdvection`",
                          "heat that stays where it is although particles are shifted");
    add<WaterIce>(cases, "`Melting` and `HeatConduction`", "what melts and freezes");
    add<WaterIceAtRest>(cases, "the same with `EnthalpyPorosity`", "ice in a mould that rests");
    add<WaterIceElastic>(cases, "the same with `FrozenStress` and `VelocityGradient`", "ice that moves and bends");
    add<Cohesive>(cases,
                  "a liquid with the method `CohesiveFluid` and a support of 5 spacings: `CohesivePressure`, "
                  "`SummationDensity`, `SymmetricPressure`, `Cohesion`",
                  "surface tension without a gas; what the rows below are compared with");
    add<CohesiveReading>(cases, "`LiquidPressure`, whose sums are `PressureVirial` and `CohesionVirial`",
                         "the pressure in a drop, to be looked at");
    add<Rubber>(
        cases,
        "a solid with a stress rate: `LinearState`, `Continuity`, `VelocityGradient`, `JaumannStress`, `StressForce`",
        "what the rows below are compared with");
    add<RubberArtificial>(cases, "`ArtificialStress`", "keeps particles from clumping under tension");
    add<RubberMonaghan>(cases, "`MonaghanViscosity`", "damps waves that go from particle to particle");
    add<RubberNormal>(cases, "`SurfaceNormal`", "which way a surface faces, for `SurfaceNormalPressure`");
    add<RubberHughesWinget>(cases, "`HughesWingetStress` in place of `JaumannStress`", "solids that turn far");
    add<RubberCorrected>(cases,
                         "`CorrectedContinuity`, `CorrectedVelocityGradient` and `CorrectedStressForce` with "
                         "`CurrentCorrection` in place of those without",
                         "strains that are right at free surfaces");
    add<Plate>(cases,
               "a total-Lagrangian solid: `ReferenceCorrection`, `DeformationGradient`, `StVenantKirchhoff`, "
               "`TotalLagrangianForce`",
               "what the rows below are compared with");
    add<PlateHourglass>(cases, "`HourglassControl`", "resists motions that leave the deformation gradient as it is");
    add<PlateViscosity>(cases, "`TotalLagrangianViscosity`", "damps what rings");
    add<PlateClamped>(cases, "`Clamped`", "holds some of the particles where they are");
    add<PlateCauchy>(cases, "`CauchyStress`", "the stress as others write it, for output");
    add<PlateAveraged>(cases, "`TimeAveragedMotion`", "a stiff solid that `Subcycled` steps by itself");
    add<PlateNeoHookean>(cases, "`CompressibleNeoHookean` in place of `StVenantKirchhoff`",
                         "large strains, above all compression");
    add<PlateIsochoric>(cases, "`IsochoricNeoHookean` in place of `StVenantKirchhoff`",
                        "large strains, shape and volume apart");
    add<PlateFinite>(cases, "`FiniteStrainLimit<StVenantKirchhoff>` in place of `StVenantKirchhoff`",
                     "solids that are held at great strains");
    add<PlatePairwise>(cases, "`PairwiseShearForce` in place of law and force",
                       "solids that are hit, twisted or bent hard");
    add<PlateVolumetric>(cases, "`VolumetricDeviatoric` in place of `StVenantKirchhoff`",
                         "rubber that hardly changes its volume");
    add<Floor, OnTop<Water, Floor>>(cases, "the plain fluid on a floor that it does not see",
                                    "what the rows below are compared with");
    add_contact<FloorExtrapolation>(
        cases, "`PressureExtrapolation`, with `VolumePressure` and `VolumeContinuity` between the two", "walls");
    add_contact<FloorNoSlip>(cases, "the same with `NoSlipVelocity` and `NoSlipViscosity`",
                             "walls that a viscous fluid sticks to");
    add_contact<FloorLinearNoSlip>(cases, "the same as the first with `LinearNoSlipVelocity` and `NoSlipViscosity`",
                                   "curved walls that a viscous fluid sticks to");
    add_contact<FloorNoSlipContinuity>(cases,
                                       "the same with `NoSlipVelocity`, `NoSlipViscosity` and `NoSlipContinuity`",
                                       "slow flow around grains and fibres");
    add_contact<FloorLoaded>(cases, "the same as the first with `ReactionForce`",
                             "the force on a wall, to be looked at");
    add_contact<FloorRiemann>(cases, "`RiemannWallNormal`, `RiemannWallPressure`, `RiemannWallContinuity`",
                              "walls that are hit");
    add_contact<FloorRepulsion>(cases, "`KernelRepulsion`", "the paper's walls; a guard beside one of the others");
    add_contact<CorrectedFloor>(
        cases, "a fluid with `CorrectedViscosity` on a floor with `PressureExtrapolation` and `CorrectionNeighbours`",
        "what the row below is compared with");
    add_contact<CorrectedFloorNoSlip>(cases, "`NoSlipVelocity` and `CorrectedNoSlipViscosity`",
                                      "walls that such a fluid sticks to");
    add_contact<PasteFloor>(cases,
                            "a fluid with `GeneralisedNewtonianViscosity` on a floor with `PressureExtrapolation`",
                            "what the row below is compared with");
    add_contact<PasteFloorNoSlip>(cases, "`NoSlipVelocity`, `NoSlipStrainRate` and `NoSlipApparentViscosity`",
                                  "walls that such a fluid sticks to");
    add_contact<Layers>(cases,
                        "two plain fluids, one on the other, with `VolumePressure` and `VolumeContinuity` between them",
                        "what the row below is compared with");
    add_contact<LayersTension>(cases, "`InterfaceTension` and `InterfaceForce`",
                               "liquids that do not mix; drops, bubbles");
    add<DropFloor, OnTop<Drop, Floor, DropBelow, LayersTension, DropFloor>>(
        cases, "such a fluid on a floor with `PressureExtrapolation`", "what the row below is compared with");
    add<DropFloorAngle, OnTop<Drop, Floor, DropBelow, LayersTension, DropFloorAngle>>(
        cases, "`ContactAngle` and `ContactLineForce`", "the angle at which an interface meets walls and solids");
    add<CohesiveFloor, OnTop<Cohesive, Floor, CohesiveFloor>>(cases, "a floor, with `CohesiveContact` and `Adhesion`",
                                                              "drops and menisci of one liquid on walls that it wets");
    add_contact<WarmFloor>(
        cases, "a fluid with `Melting`, `HeatConduction` and `Boussinesq` on a floor with `PressureExtrapolation`",
        "what the rows below are compared with");
    add_contact<WarmFloorBuoyant>(cases, "`BoussinesqExtrapolation`", "floors under a fluid that expands");
    add_contact<WarmFloorFrozen>(cases, "`FrozenDrag`", "ice that holds on to walls and solids");
    add_contact<WarmFloorHeated>(cases, "`HeatFlux` and `HeatFromWalls`", "walls that heat");
    add_contact<WarmFloorHot>(cases, "`SurfaceTemperature`, `TemperatureExtrapolation` and `HeatTransfer`",
                              "walls at a temperature");
    add<Slab, OnTop<Water, Slab>>(cases, "the plain fluid on a total-Lagrangian slab that it does not see",
                                  "what the rows below are compared with");
    add<Soaked, Overlap<Seeping, Skeleton, Soaked>>(
        cases,
        "`InPores`, `PoreDensityDiffusion`, `PoreDensityFloor`, `PorousSkeleton`, `PoreSpace`, `PoreContents`, "
        "`PorePressure` and `DarcyDrag`",
        "pores too small to resolve: a skeleton in all of the cube, both phases together");
    add<SoakedWarm, Overlap<WarmSeeping, WarmSkeleton, SoakedWarm>>(
        cases, "the same with `HeatCapacity`, `HeatConduction`, `PoreHeatConduction` and `PoreHeatExchange`",
        "heat in such pores");
    add_contact<SlabExtrapolation>(
        cases, "`PressureExtrapolation`, with `VolumePressure` and `VolumeContinuity` between the two",
        "pressure without a number to choose");
    add_contact<SlabRiemann>(cases, "`RiemannWallNormal`, `RiemannWallPressure`, `RiemannWallContinuity`",
                             "the same, for impacts; what depends least on the support");
    add_contact<SlabNormals>(cases, "`ReferenceSurfaceNormal`, `SurfaceNormalPressure` and `VolumeContinuity`",
                             "pressure along the normals of a thick solid");
    add_contact<SlabModified>(cases, "`ModifiedRepulsion`", "water that only has to stay outside");
    add_contact<SlabRepulsion>(cases, "`KernelRepulsion`", "the paper's coupling");
    return cases;
}

} // namespace

int main(int argc, char** argv) {
    const auto cases = all_cases();
    const std::string last = argc > 1 ? argv[argc - 1] : "";
    if (argc == 2 && cases.contains(last)) {
        std::printf("items %.0f\n", cases.at(last).count());
        return 0;
    }
    if (argc == 3 && std::string(argv[1]) == "--time" && cases.contains(last)) {
        std::printf("nanoseconds %.1f\n", cases.at(last).nanoseconds());
        return 0;
    }
    for (const auto& [name, it] : cases)
        std::printf("case %s\ncosts %s %s | %s | %s\n", name.c_str(), name.c_str(), it.costs.c_str(), it.effect.c_str(),
                    it.good_for.c_str());
    bench::print_compiler();
    return argc == 1 ? 0 : 2;
}
