// One row for every reason that limits a time step but `acceleration`, which says how far particles are thrown.
#include "limits.hpp"
#include "rows.hpp"

namespace stability {

void add_limits(Table& table) {
    const auto row = [&](const char* composition, const char* scene, std::function<Outcome(const Plan&)> run) {
        table.rows.push_back({"Limits", composition, scene, 0, std::move(run)});
    };
    constexpr double disorder = 0.3; // spacings, to either side: many pairs are nearer than half a spacing
    row("LinearState, WendlandC2, H = 2.6", "shaken box",
        [](const Plan& p) { return shaken_box(p, liquid<Sound>(), 2.6); });
    row("LinearState, WendlandC2, H = 3", "shaken box",
        [](const Plan& p) { return shaken_box(p, liquid<Sound>(), 3); });
    row("LinearState, WendlandC2, H = 2.6", "shaken box in 3D",
        [](const Plan& p) { return shaken_box<Sound, 3>(p, liquid<Sound>(), 2.6); });
    row("LinearState, WendlandC2, H = 2.6", "disordered shaken box",
        [=](const Plan& p) { return shaken_box(p, liquid<Sound>(), 2.6, disorder); });
    row("LinearState, WendlandC2, H = 2.6", "disordered shaken box in 3D",
        [=](const Plan& p) { return shaken_box<Sound, 3>(p, liquid<Sound>(), 2.6, disorder); });
    row("Tait<7>, Spiky, H = 1.25", "shaken box", shaken_water<Paper>);
    row("LinearState, WendlandC2, H = 1.25", "shaken box, disordered by a tenth",
        [](const Plan& p) { return shaken_box(p, liquid<Sound>(), 1.25, 0.1); });
    row("LinearState, WendlandC2, H = 1.25", "shaken box in 3D, disordered by a tenth",
        [](const Plan& p) { return shaken_box<Sound, 3>(p, liquid<Sound>(), 1.25, 0.1); });
    row("LinearState, WendlandC2, H = 1.25, rough", "disordered shaken box",
        [=](const Plan& p) { return shaken_box(p, liquid<Sound>(), 1.25, disorder); });
    row("DensityFloor, rate = 20", "shaken box", [](const Plan& p) {
        auto water = liquid<Floored>();
        water.set(sph::DensityFloorParameters{.rate = 20});
        return shaken_box(p, water, 2.6);
    });
    row("SummationFloor, rate = 20", "shaken box", [](const Plan& p) {
        auto water = liquid<RaisedToSum>();
        water.set(sph::SummationFloorParameters{.rate = 20});
        return shaken_box(p, water, 2.6);
    });
    row("SummationRelaxation, time = 2e-6 s", "shaken box", [](const Plan& p) {
        auto water = liquid<Relaxed>();
        water.set(sph::SummationRelaxationParameters{.time = 2e-6});
        return shaken_box(p, water, 2.6);
    });
    row("Cohesion, kappa = 10 rho c^2, H = 5", "shaken disc", [](const Plan& p) { return shaken_cohesion(p, 10); });
    row("Cohesion, kappa = 0.4 rho c^2, H = 5", "shaken disc", [](const Plan& p) { return shaken_cohesion(p, 0.4); });
    row("ParticleShifting, H = 3", "box of nothing else", [](const Plan& p) { return shifted_box<2>(p, 3); });
    row("ParticleShifting, H = 4", "box of nothing else", [](const Plan& p) { return shifted_box<2>(p, 4); });
    row("ParticleShifting, H = 2.6", "box of nothing else in 3D", [](const Plan& p) { return shifted_box<3>(p, 2.6); });
    for (const double moved : {0.0, disorder}) {
        const char* box = moved > 0 ? "disordered shaken box" : "shaken box";
        row("DensityDiffusion, delta = 1", box, [=](const Plan& p) {
            auto water = liquid<Diffusing>();
            water.set(sph::DensityDiffusionParameters{.delta = 1});
            return shaken_box(p, water, 2.6, moved);
        });
        row("AntuonoDiffusion, delta = 1", box, [=](const Plan& p) {
            auto water = liquid<Antuono>();
            water.set(sph::AntuonoDiffusionParameters{.delta = 1});
            return shaken_box(p, water, 2.6, moved);
        });
        row("MorrisViscosity", box, [=](const Plan& p) { return shaken_box(p, liquid<Morris>(200), 2.6, moved); });
        row("ClearyViscosity", box, [=](const Plan& p) { return shaken_box(p, liquid<Cleary>(200), 2.6, moved); });
    }
    for (const double moved : {0.0, disorder}) {
        row("HeatConduction, H = 2.6", moved > 0 ? "disordered square of heat" : "square of heat",
            [=](const Plan& p) { return warm_drop<2>(p, 2.6, moved); });
        row("HeatConduction, H = 2.6", moved > 0 ? "disordered cube of heat" : "cube of heat",
            [=](const Plan& p) { return warm_drop<3>(p, 2.6, moved); });
        row("HeatTransfer with walls at a temperature", moved > 0 ? "disordered channel of heat" : "channel of heat",
            [=](const Plan& p) { return warm_channel(p, 2.6, moved); });
    }
    row("HeatTransfer, ten times the conductivity", "two layers of heat",
        [](const Plan& p) { return warm_layers(p, 10); });
    row("PorePressure, porosity 0.3", "shaken skeleton as dense as water, full of it",
        [](const Plan& p) { return shaken_foam(p, 0.3, 1000); });
    row("PorePressure, porosity 0.3", "shaken light skeleton, full of water",
        [](const Plan& p) { return shaken_foam(p, 0.3, 300); });
    row("PorePressure, porosity 0.8", "shaken light skeleton, full of water",
        [](const Plan& p) { return shaken_foam(p, 0.8, 300); });
    row("PoreHeatExchange, porosity 0.3", "heat of a fluid in pores", [](const Plan& p) { return warm_pores(p, 0.3); });
    row("PoreHeatExchange, porosity 0.8", "heat of a fluid in pores", [](const Plan& p) { return warm_pores(p, 0.8); });
    row("FrozenStress, G = 3 rho c^2", "shaken box of ice", [](const Plan& p) { return shaken_box(p, frozen(), 2.6); });
    row("FrozenStress, G = 3 rho c^2", "disordered shaken box of ice",
        [=](const Plan& p) { return shaken_box(p, frozen(), 2.6, disorder); });
    for (const double moved : {0.0, disorder}) {
        row("CorrectedPressure, H = 2.6", moved > 0 ? "disordered shaken drop" : "shaken drop",
            [=](const Plan& p) { return shaken_drop(p, liquid<CorrectedLiquid>(), 2.6, moved); });
        row("CorrectedPressure, H = 2.6", moved > 0 ? "disordered shaken drop in 3D" : "shaken drop in 3D",
            [=](const Plan& p) { return shaken_drop<CorrectedLiquid, 3>(p, liquid<CorrectedLiquid>(), 2.6, moved); });
        row("CorrectedViscosity, H = 2.6", moved > 0 ? "disordered shaken drop" : "shaken drop",
            [=](const Plan& p) { return shaken_drop(p, liquid<CorrectedSyrup>(200), 2.6, moved); });
    }
    row("CorrectedPressure, H = 2.6", "disordered shaken box",
        [=](const Plan& p) { return shaken_box(p, liquid<CorrectedLiquid>(), 2.6, disorder); });
    row("NoSlipViscosity", "shaken box between plates",
        [](const Plan& p) { return shaken_channel<Morris, NoSlipPlates>(p, liquid<Morris>(200), 2.6); });
    row("CorrectedNoSlipViscosity", "shaken box between plates", [](const Plan& p) {
        return shaken_channel<CorrectedSyrup, CorrectedNoSlipPlates>(p, liquid<CorrectedSyrup>(200), 2.6);
    });
    row("LaminarViscosity, H = 1.25", "shaken box",
        [](const Plan& p) { return shaken_box(p, liquid<Laminar>(200), 1.25); });
    row("LaminarViscosity, H = 2.6", "shaken box",
        [](const Plan& p) { return shaken_box(p, liquid<Laminar>(200), 2.6); });
    row("MonaghanViscosity, alpha = 10", "shaken box", [](const Plan& p) {
        auto water = liquid<Monaghan>();
        water.set(sph::MonaghanViscosityParameters{.alpha = 10, .beta = 0});
        return shaken_box(p, water, 2.6);
    });
    row("RiemannContinuity", "shaken box", shaken_water<Riemann>);
    row("RiemannPressure, eta = 1e6", "shaken box", [](const Plan& p) {
        auto water = liquid<Waves>();
        water.set(sph::RiemannPressureParameters{.eta = 1e6});
        return shaken_box(p, water, 3);
    });
    row("RiemannWallPressure, eta = 1e6", "shaken box between plates", [](const Plan& p) {
        return shaken_channel<Sound, RiemannPlates>(p, liquid<Sound>(), 2.6,
                                                    sph::RiemannWallPressureParameters{.eta = 1e6});
    });
    row("RiemannWallPressure, eta = 1e6, H = 2.6", "particles without pressure at a wall",
        [](const Plan& p) { return dust_at_wall(p, 2.6); });
    row("RiemannWallPressure, eta = 1e6, H = 3", "particles without pressure at a wall",
        [](const Plan& p) { return dust_at_wall(p, 3); });
    row("VolumePressure between fluids", "shaken gas, a thousandth of the density, beside water", [](const Plan& p) {
        return shaken_layers<SoundMeetsGas>(p, liquid<Sound>(), Gas{{.density = 1, .sound_speed = 30}});
    });
    const char* soft = "shaken raft, soft, a twentieth of the density, beside water";
    row("VolumePressure at a solid", soft,
        [](const Plan& p) { return shaken_layers<RaftOnPressure>(p, liquid<Sound>(), raft<Raft>(0.05)); });
    row("RiemannWallPressure", soft,
        [](const Plan& p) { return shaken_layers<RaftOnRiemann>(p, liquid<Sound>(), raft<Raft>(0.05)); });
    row("SurfaceNormalPressure", soft, [](const Plan& p) { // whose forces do other work than VolumeContinuity counts
        auto water = liquid<Monaghan>();
        water.set(sph::MonaghanViscosityParameters{.alpha = 0.1});
        return shaken_layers<RaftOnNormals>(p, water, raft<RaftWithNormals>(0.05));
    });
    const auto repelled = [&](const char* name, double stiffness, double support) {
        row(name, "particles between two plates", [stiffness, support](const Plan& p) {
            return bounce<sph::KernelRepulsion<>>(p, support, sph::KernelRepulsionParameters{.stiffness = stiffness});
        });
    };
    repelled("KernelRepulsion, K_f = 1e8, H = 1.25", 1e8, 1.25);
    repelled("KernelRepulsion, K_f = 1e6, H = 1.25", 1e6, 1.25);
    repelled("KernelRepulsion, K_f = 1e8, H = 2", 1e8, 2);
    row("KernelRepulsion, K_f = 1e8, H = 1.25", "particles at rest, 0.3 supports from a plate",
        [](const Plan& p) { return let_go(p, 0.3, 1e8); });
    row("KernelRepulsion, K_f = 1e8, H = 1.25", "particles at rest, 0.8 supports from a plate",
        [](const Plan& p) { return let_go(p, 0.8, 1e8); });
    row("KernelRepulsion within a phase", "pairs that meet, a tenth of the barrier",
        [](const Plan& p) { return marbles(p, 0.1); });
    row("KernelRepulsion within a phase", "pairs that meet, 0.7 of the barrier",
        [](const Plan& p) { return marbles(p, 0.7); });
    row("ModifiedRepulsion, U = 20", "particles between two plates", [](const Plan& p) {
        return bounce<sph::ModifiedRepulsion>(p, 1.25, sph::ModifiedRepulsionParameters{.speed = 20, .restitution = 1});
    });

    using Kirchhoff2 = Kirchhoff::Body;
    row("StVenantKirchhoff, nu 0.3, H = 2", "shaken block",
        [](const Plan& p) { return shaken_block<2, Kirchhoff2>(p, 0.3, 2.01); });
    row("StVenantKirchhoff, nu 0.3, H = 1.5", "shaken block",
        [](const Plan& p) { return shaken_block<2, Kirchhoff2>(p, 0.3, 1.5); });
    row("StVenantKirchhoff, nu 0.3, H = 2", "shaken block in 3D",
        [](const Plan& p) { return shaken_block<3, Kirchhoff2>(p, 0.3, 2.01); });
    row("StVenantKirchhoff, nu 0.499, H = 2", "shaken block in 3D",
        [](const Plan& p) { return shaken_block<3, Kirchhoff2>(p, 0.499, 2.01); });
    row("StVenantKirchhoff, nu 0.3, H = 1.5", "shaken block in 3D",
        [](const Plan& p) { return shaken_block<3, Kirchhoff2>(p, 0.3, 1.5); });
    row("StVenantKirchhoff, nu 0.499, H = 1.5", "shaken block in 3D",
        [](const Plan& p) { return shaken_block<3, Kirchhoff2>(p, 0.499, 1.5); });
    row("CompressibleNeoHookean, nu 0.3, H = 2", "shaken block",
        [](const Plan& p) { return shaken_block<2, Hookean::Body>(p, 0.3, 2.01); });
    row("VolumetricDeviatoric, nu 0.499, H = 2", "shaken block",
        [](const Plan& p) { return shaken_block<2, Averaged::Body>(p, 0.499, 2.01); });
    row("PairwiseShearForce, nu 0.3, H = 2", "shaken block",
        [](const Plan& p) { return shaken_block<2, ShearFromPairs>(p, 0.3, 2.01); });
    row("HourglassControl, alpha = 20", "shaken block", [](const Plan& p) {
        return shaken_block<2, Kirchhoff2>(p, 0.3, 2.01, sph::HourglassControlParameters{.alpha = 20});
    });
    row("HourglassControl, alpha = 20", "shaken block in 3D", [](const Plan& p) {
        return shaken_block<3, Kirchhoff2>(p, 0.3, 2.01, sph::HourglassControlParameters{.alpha = 20});
    });
    row("TotalLagrangianViscosity, alpha = 20", "shaken block", [](const Plan& p) {
        return shaken_block<2, Kirchhoff2>(p, 0.3, 2.01, sph::TotalLagrangianViscosityParameters{.alpha = 20});
    });
    row("ReferenceCorrection", "row of particles, rough by 0.4 spacings",
        [](const Plan& p) { return shaken_sheet<2>(p, 0.4); });
    for (const double rough : {0.2, 0.3, 0.45})
        row("ReferenceCorrection",
            rough == 0.2   ? "sheet of particles, rough by 0.2 spacings"
            : rough == 0.3 ? "sheet of particles, rough by 0.3 spacings"
                           : "sheet of particles, rough by 0.45 spacings",
            [=](const Plan& p) { return shaken_sheet<3>(p, rough); });
    for (const double poisson : {0.3, 0.499}) {
        const char* law = poisson == 0.3 ? "StVenantKirchhoff, nu 0.3, thin" : "StVenantKirchhoff, nu 0.499, thin";
        row(law, "shaken block of two by two", [=](const Plan& p) {
            return shaken_body<2, Kirchhoff2>(p, {2, 2}, poisson, 2.01);
        });
        row(law, "shaken block of two by two by two", [=](const Plan& p) {
            return shaken_body<3, Kirchhoff2>(p, {2, 2, 2}, poisson, 2.6);
        });
        row(law, "shaken plate of two layers", [=](const Plan& p) {
            return shaken_body<3, Kirchhoff2>(p, {8, 8, 2}, poisson, 2.6);
        });
        row(law, "shaken bar of three by three", [=](const Plan& p) {
            return shaken_body<3, Kirchhoff2>(p, {8, 3, 3}, poisson, 2.6);
        });
    }
    row("paper's hypoelastic, nu 0.3", "shaken block",
        [](const Plan& p) { return shaken_block<2, Hypoelastic::Body>(p, 0.3, 2); });
    row("a spring to the origin", "one particle, let go a tenth of a spacing away", swing);
}

} // namespace stability
