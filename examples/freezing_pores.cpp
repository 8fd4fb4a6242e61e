// Water that flows through a slice of a porous body freezes from a cold plate on, in two dimensions: ice closes the
// pores one after the other, until nothing passes any more. The slice is 1 mm high and periodic along the flow, which a
// force drives. Its fibres conduct heat; the water is at its melting point, the plate below 20 K colder, the lid
// insulated. The ice grows as in a body of the mean properties (Stefan 1891, with the latent heat of the share n of
// pores).
//
//   build/freezing_pores                writes out-freezing-pores and freezing-pores.csv
//   build/freezing_pores 60             with 60 instead of 40 particles over the height
//   python3 tools/render_plane.py out-freezing-pores --walls fibres plate lid --times 10 510 1510 2510
//   python3 tools/plot_curves.py freezing-pores.csv
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>

#include <cstdio>
#include <fstream>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::UnderPressure<>, sph::CorrectedGradients<K>, sph::Instead<sph::DensityFloor>,
                          sph::MorrisViscosity<K>, sph::Melting, sph::HeatConduction<K>, sph::EnthalpyPorosity> {};
struct Fibres : sph::Wall<sph::HeatCapacity, sph::HeatConduction<K>> {};
struct Plate : sph::Wall<sph::SurfaceTemperature> {};
struct Lid : sph::Wall<> {};
template <class Body, class... More>
using Sticky = sph::CouplingOf<Water, Body, sph::Into<Body, sph::NoSlipVelocity<K>>, sph::NoSlipViscosity<K>, More...>;
struct InPores : Sticky<Fibres, sph::HeatTransfer<K>> {};
struct AtPlate : Sticky<Plate, sph::Into<Plate, sph::TemperatureExtrapolation<K>>, sph::HeatTransfer<K>> {};
struct AtLid : Sticky<Lid> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Water, Fibres, Plate, Lid, InPores, AtPlate, AtLid>;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double across = sph::example::number(argv, 1, "the number of particles over the height", 40, 30, 400);
        const double L = 1e-3, dx = L / across, push = 1, viscosity = 1.8e-3, rho = 1000, cold = 20, k = 2.2, c = 2100;
        Scene scene({.gravity = {push, 0}, .support_radius = 2.6 * dx, .periodic_length = {L, 0}});
        Water water{{.density = rho, .sound_speed = 0.1, .viscosity = viscosity}};
        water.set(sph::UnderPressureParameters{.background = 2 * rho * push * L});
        const double latent = 3.34e5, liquid_c = 4200, liquid_k = 0.56, fibre_c = 2000, fibre_k = 1.5;
        water.set(sph::MeltingParameters{c, liquid_c, k, liquid_k, latent, 0, 0, 0});
        Fibres body{{.density = rho}};
        body.set(sph::HeatParameters{fibre_c, fibre_k, 0});
        Plate plate{{.density = rho}};
        plate.set(sph::SurfaceTemperatureParameters{.surface_temperature = -cold});
        const auto disc = [&](double x, double y) { return sph::Sphere<2>{{x * L, y * L}, L / 14}; };
        const auto rows = disc(.125, .125) | disc(.625, .125) | disc(.375, .375) | disc(.875, .375) | disc(.125, .625) |
                          disc(.625, .625) | disc(.375, .875) | disc(.875, .875);
        const sph::Box<2> slice({0, 0}, {L, L});
        const auto places = sph::fitted_together(dx, {0, 0}, 0, rows, slice - rows);
        const auto pores = scene.add(water, places[1], dx);
        scene.add(body, places[0], dx);
        scene.add(plate, sph::fill(sph::Box<2>{{0, -3 * dx}, {L, 0}}, dx), dx);
        scene.add(Lid{{.density = rho}}, sph::fill(sph::Box<2>{{0, L}, {L, L + 3 * dx}}, dx), dx);
        const double n = 1 - dx * dx * double(places[0].size()) / slice.volume();
        const double mean_k = n * k + (1 - n) * fibre_k, mean_c = n * c + (1 - n) * fibre_c,
                     stefan = mean_c * cold / (n * latent); // lambda^2 = St/2/(1 + St/3), to 0.1 % where St < 0.5
        const double growth =
            std::sqrt(2 * stefan / (1 + stefan / 3) * mean_k / (rho * mean_c)); // 2 lambda sqrt(kappa)
        std::ofstream table("freezing-pores.csv");
        sph::require(table.good(), "freezing-pores.csv cannot be written in this folder. Go to one that can be.");
        table << "time [s],permeability [1e-12 m^2],height of ice [mm],mean properties [mm]\n";
        sph::Snapshots snapshots("out-freezing-pores");
        for (double ice = 0, t = 0.01; ice < 0.99 && t < 60; t += 0.1) {
            scene.run_until(t);
            ice = 1 - scene[pores][sph::liquid_fraction].mean();
            const double U = scene[pores][sph::velocity].col(0).sum() * dx * dx / (L * L);
            const double permeability = viscosity * U / (rho * push), front = growth * std::sqrt(t);
            std::printf("%.2f s: %2.0f %% of the water is ice, k = %.3g m^2\n", t, 100 * ice, permeability);
            table << t << ',' << 1e12 * permeability << ',' << ice << ',' << std::min(1e3 * front, 1.0) << '\n';
            snapshots(scene);
        }
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "freezing_pores: %s\n", error.what());
        return 2;
    }
}
