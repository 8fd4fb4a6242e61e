// A wall that lets slip, one that sticks roughly and two that stick, told apart by what flows between two plates.
#include <imbibe/imbibe.hpp>

#include <cstdio>

namespace sph = imbibe;
using K = sph::WendlandC2;

template <class Viscosity>
struct Oil : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::Instead<sph::DensityFloor>, Viscosity> {};
struct Plates : sph::Wall<> {};

// What such a fluid needs at a wall, and after it what makes the oil stick, if anything does.
template <class Oil, class... Sticking>
struct Contact : sph::CouplingOf<Oil, Plates, Sticking...> {};

/// The greatest error of the velocity of plane Poiseuille flow once it is steady, as a share of the greatest velocity.
template <class Oil, class... Sticking>
double error() {
    const double gap = 0.01, length = 0.005, dx = gap / 20, rho = 1000, eta = 0.1, force = 0.1;
    const double fastest = rho * force * gap * gap / (8 * eta);
    sph::Solver<2, double, sph::SymplecticEuler, Oil, Plates, Contact<Oil, Sticking...>> scene(
        {.gravity = {force, 0}, .support_radius = 3 * dx, .periodic_length = {length, 0}});
    const sph::Box<2> between{{0, 0}, {length, gap}};
    const auto oil =
        scene.add(Oil{{.density = rho, .sound_speed = 10 * fastest, .viscosity = eta}}, sph::fill(between, dx), dx);
    scene.add(Plates{{.density = rho}}, sph::tank(between, dx, 3, sph::Sides::x), dx);
    scene.run_until(1.5 * gap * gap * rho / eta);

    double worst = 0;
    const auto view = scene[oil];
    for (int i = 0; i < view.size(); ++i) {
        const double y = view[sph::position](i, 1), exact = rho * force / (2 * eta) * y * (gap - y);
        worst = std::max(worst, std::abs(view[sph::velocity](i, 0) - exact));
    }
    return worst / fastest;
}

int main() {
    using Morris = sph::MorrisViscosity<K>;
    using Cleary = sph::ClearyViscosity<K>;
    using Shown = sph::Into<Plates, sph::NoSlipVelocity<K>>;
    using NoSlip = sph::NoSlipViscosity<K>;
    const double slip = error<Oil<Morris>>();
    const double cleary = error<Oil<Cleary>, Cleary>(), cleary_no_slip = error<Oil<Cleary>, Shown, NoSlip>();
    const double morris = error<Oil<Morris>, Morris>(), morris_no_slip = error<Oil<Morris>, Shown, NoSlip>();
    std::printf("greatest error of the velocity, 20 particles across, as a share of the greatest velocity\n"
                "in the oil        in the coupling                       error\n"
                "MorrisViscosity   nothing viscous: it slips           %5.0f %%\n"
                "ClearyViscosity   ClearyViscosity                     %7.1f %%\n"
                "MorrisViscosity   MorrisViscosity                     %7.1f %%\n"
                "ClearyViscosity   NoSlipVelocity, NoSlipViscosity     %7.1f %%\n"
                "MorrisViscosity   NoSlipVelocity, NoSlipViscosity     %7.1f %%\n",
                100 * slip, 100 * cleary, 100 * morris, 100 * cleary_no_slip, 100 * morris_no_slip);
    return slip > 1 && cleary > 0.1 && cleary < 0.3 && morris > 0.1 && morris < 0.15 && cleary_no_slip < 0.08 &&
                   morris_no_slip < 0.01
               ? 0
               : 1;
}
