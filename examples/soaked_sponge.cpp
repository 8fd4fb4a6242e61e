// A kitchen sponge, cut through: it falls into a tray of water, drinks until it is full, is squeezed to two thirds of
// its height, gives water back, and drinks again when it is let go. Its pores are too small to resolve: the sponge and
// the water in it are two phases in the same place (docs/policies.md, pores too small to resolve).
//
//   build/soaked_sponge                 writes out-soaked-sponge and soaked-sponge.csv
//   build/soaked_sponge 1               with a spacing of 1 instead of 1.5 mm
//   build/soaked_sponge 1.5 200         with a suction of 200 instead of 400 Pa: pores that are twice as wide
//   build/soaked_sponge 1.5 400 1e-10   with a tenth of the permeability
//   python3 tools/render_plane.py out-soaked-sponge --walls tray plate --field sponge saturation
//   python3 tools/plot_curves.py soaked-sponge.csv
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/soaked_sponge.hpp>

#include <cstdio>
#include <fstream>

namespace sph = imbibe;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        sph::presets::SoakedSpongeCase numbers;
        numbers.spacing = 1e-3 * sph::example::number(argv, 1, "the spacing in mm", 1.5, 0.5, 3);
        numbers.suction = sph::example::number(argv, 2, "the suction in Pa", 400, 0, 2000);
        numbers.permeability = sph::example::number(argv, 3, "the permeability in m^2", 1e-9, 1e-14, 1e-7);
        auto run = sph::presets::SoakedSponge::make<float>(numbers);
        std::printf("%s", sph::describe(run.scene).c_str());

        std::ofstream table("soaked-sponge.csv");
        sph::require(table.good(), "soaked-sponge.csv cannot be written in this folder. Go to one that can be.");
        table << "time [s],water in the sponge [kg/m],height of the sponge [mm],force on the plate [N/m]\n";
        sph::Snapshots snapshots("out-soaked-sponge");
        const double end = numbers.released_at + numbers.pressed_for + 2;
        for (int frame = 0; 0.1 * frame < end + 0.01; ++frame) {
            run.run_until(0.1 * frame);
            snapshots(run.scene);
            table << 0.1 * frame << ',' << run.drunk() << ',' << 1e3 * run.sponge_height() << ',' << run.force()
                  << '\n';
            if (frame % 5 == 0)
                std::printf(
                    "%4.1f s: %.2f of %.2f kg/m in the sponge, which is %.1f mm high; the plate bears %.0f N/m\n",
                    0.1 * frame, run.drunk(), run.room(), 1e3 * run.sponge_height(), run.force());
        }
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "soaked_sponge: %s\n", error.what());
        return 2;
    }
}
