// The reference cases: scenes with numbers from outside (cases/validation/, one case a file), each run at several
// resolutions. Prints the errors and the order at which they fall, and keeps them in the table of
// docs/validation_table.md.
//
//   build-benchmark/studies/validation couette cylinders            some of them
//   build-benchmark/studies/validation turek-hron --resolutions 4   coarse only
//   build-benchmark/studies/validation all --write docs/validation_table.md
#include <cases/validation/biot.hpp>
#include <cases/validation/capillary_filling.hpp>
#include <cases/validation/capillary_rise.hpp>
#include <cases/validation/capillary_tube.hpp>
#include <cases/validation/capillary_wave.hpp>
#include <cases/validation/cavity.hpp>
#include <cases/validation/cylinders.hpp>
#include <cases/validation/dam_break_at_wall.hpp>
#include <cases/validation/dam_break_on_box.hpp>
#include <cases/validation/drop_in_gas.hpp>
#include <cases/validation/drop_on_slab.hpp>
#include <cases/validation/duct.hpp>
#include <cases/validation/elastic_baffle.hpp>
#include <cases/validation/elastic_gate.hpp>
#include <cases/validation/elliptic_drop.hpp>
#include <cases/validation/fitted_bodies.hpp>
#include <cases/validation/fitted_cylinders.hpp>
#include <cases/validation/free_drop.hpp>
#include <cases/validation/frozen_pores.hpp>
#include <cases/validation/heated_cavity.hpp>
#include <cases/validation/imbibition.hpp>
#include <cases/validation/kolmogorov.hpp>
#include <cases/validation/laws_of_flow.hpp>
#include <cases/validation/one_pore.hpp>
#include <cases/validation/orifice.hpp>
#include <cases/validation/oscillating_plate.hpp>
#include <cases/validation/pipe.hpp>
#include <cases/validation/plates.hpp>
#include <cases/validation/porous_spheres.hpp>
#include <cases/validation/ramp.hpp>
#include <cases/validation/rayleigh_taylor.hpp>
#include <cases/validation/report.hpp>
#include <cases/validation/rising_bubble.hpp>
#include <cases/validation/sessile_drop.hpp>
#include <cases/validation/slotted_sponge.hpp>
#include <cases/validation/soft_plate.hpp>
#include <cases/validation/spheres.hpp>
#include <cases/validation/spinning_plate.hpp>
#include <cases/validation/square_patch.hpp>
#include <cases/validation/standing_wave.hpp>
#include <cases/validation/stefan.hpp>
#include <cases/validation/stiff_plate.hpp>
#include <cases/validation/still_layers.hpp>
#include <cases/validation/still_water.hpp>
#include <cases/validation/sunken_sponge.hpp>
#include <cases/validation/taylor_green.hpp>
#include <cases/validation/turek_hron.hpp>
#include <cases/validation/turek_hron_flow.hpp>
#include <cases/validation/turned_beam.hpp>
#include <cases/validation/wetting_drop.hpp>
#include <cases/validation/wetting_filling.hpp>
#include <cases/validation/wetting_rise.hpp>
#include <cases/validation/wetting_slab.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <optional>

using namespace validation;

int main(int argc, char** argv) {
    const std::vector<Case> cases{
        {"still-water", "particles along a side", {20, 40}, still_water::measure},
        {"poiseuille", "particles across the gap", {12, 25, 50}, plates::measure_poiseuille},
        {"taylor-green", "particles along a side", {50, 100}, taylor_green::measure},
        {"kolmogorov", "particles along a side", {32, 64}, kolmogorov::measure},
        {"laws-of-flow", "particles across the gap", {12, 25}, laws_of_flow::measure},
        {"capillary-wave", "particles in its length", {32, 64}, capillary_wave::measure},
        {"sessile-drop", "particles over the radius", {12, 24}, sessile_drop::measure},
        {"capillary-rise", "particles between the plates", {12, 24}, capillary_rise::measure},
        {"capillary-tube", "particles across the tube", {8, 12}, capillary_tube::measure},
        {"capillary-filling", "particles across the slit", {12, 20}, capillary_filling::measure},
        {"still-layers", "particles over a layer's height", {20, 40}, still_layers::measure},
        {"rayleigh-taylor", "particles in its length", {32, 64}, rayleigh_taylor::measure},
        {"drop-in-gas", "particles over the radius", {8, 16}, drop_in_gas::measure},
        {"drop-on-slab", "particles over the radius", {12, 24}, drop_on_slab::measure},
        {"rising-bubble", "particles over the width", {32, 64}, rising_bubble::measure},
        {"free-drop", "particles over the radius", {8, 16, 32}, free_drop::measure},
        {"free-ball", "particles over the radius", {8, 12}, free_drop::measure_ball},
        {"wetting-drop", "particles over the radius", {12, 24}, wetting_drop::measure},
        {"wetting-ball", "particles over the radius", {6, 8}, wetting_drop::measure_in_space},
        {"wetting-rise", "particles between the plates", {12, 20}, wetting_rise::measure},
        {"wetting-filling", "particles across the slit", {12, 20}, wetting_filling::measure},
        {"wetting-slab", "particles over the radius", {12, 24}, wetting_slab::measure},
        {"couette", "particles across the gap", {12, 25, 50}, plates::measure_couette},
        {"cylinders", "particles along the cell", {25, 50}, cylinders::measure},
        {"fitted-cylinders", "particles along the cell", {25, 50}, fitted_cylinders::measure},
        {"spheres", "particles along the cell", {16, 24, 32}, spheres::measure},
        {"porous-spheres", "particles along the cell", {16, 24}, porous_spheres::measure},
        {"pipe", "particles across the pipe", {12, 24, 48}, pipe::measure},
        {"duct", "particles along a side", {12, 24}, duct::measure},
        {"one-pore", "particles over the radius", {4, 6, 8}, one_pore::measure},
        {"orifice", "particles over the slot", {10, 20}, orifice::measure},
        {"frozen-pores", "particles in a length of 1", {10, 20, 40}, frozen_pores::measure},
        {"wet-layer", "particles over half of it", {20, 40}, biot::measure_layer},
        {"wet-ball", "particles over its radius", {8, 12}, biot::measure_ball},
        {"sunken-sponge", "particles over the tank", {20, 40}, sunken_sponge::measure},
        {"resolved-sponge", "particles across a slot", {4, 8, 12}, slotted_sponge::resolved::measure},
        {"mixed-sponge", "particles over the sponge", {10, 20, 40}, slotted_sponge::mixed::measure},
        {"imbibition", "particles over the column", {20, 40}, imbibition::measure},
        {"cavity", "particles along a side", {25, 50}, cavity::measure},
        {"heated-cavity", "particles along a side", {20, 40}, heated_cavity::measure},
        {"stefan", "particles in a length of 1", {20, 40, 80}, stefan::measure},
        {"cavity-1000", "particles along a side", {50, 100}, cavity::measure_faster},
        {"standing-wave", "particles over the depth", {25, 50}, standing_wave::measure},
        {"square-patch", "particles along a side", {25, 50}, square_patch::measure},
        {"elliptic-drop", "particles over the radius", {12, 25, 50}, elliptic_drop::measure},
        {"spinning-plate", "particles along a side", {10, 20}, spinning_plate::measure},
        {"oscillating-plate", "particles over the thickness", {5, 10}, oscillating_plate::measure},
        {"turned-beam", "particles over the thickness", {6, 12}, turned_beam::measure},
        {"fitted-bodies", "particles over thickness or radius", {6, 12}, fitted_bodies::measure},
        {"ramp", "particles over the depth", {5, 10}, ramp::measure},
        {"turek-hron", "particles over the thickness", {4, 6, 10, 20}, turek_hron::measure},
        {"elastic-baffle", "particles over the baffle's thickness", {3, 6}, elastic_baffle::measure},
        {"dam-break-at-wall", "particles over the depth", {40, 80}, dam_break_at_wall::measure},
        {"dam-break-on-box", "particles over the box's height", {8, 12}, dam_break_on_box::measure},
        {"stiff-plate", "particles over the plate's thickness", {5, 10}, stiff_plate::measure},
        {"soft-plate", "particles over the plate's thickness", {5, 10}, soft_plate::measure},
        {"elastic-gate", "particles over the gate's thickness", {5, 10}, elastic_gate::measure},
        {"fsi1", "particles over the flag's thickness", {4, 6}, turek_hron_flow::measure_fsi1},
        {"fsi2", "particles over the flag's thickness", {4}, turek_hron_flow::measure_fsi2},
        {"fsi3", "particles over the flag's thickness", {4}, turek_hron_flow::measure_fsi3}};

    std::vector<std::string> names{"all"}, chosen;
    for (const Case& c : cases)
        names.push_back(c.name);
    std::string file;
    std::vector<int> resolutions;
    CLI::App app{"Scenes with a reference from outside: how far off they are, and how fast that falls."};
    app.add_option("cases", chosen, "which to run, or all")->required()->check(CLI::IsMember(names));
    app.add_option("--resolutions", resolutions, "instead of each case's own, coarse to fine")
        ->check(CLI::PositiveNumber);
    app.add_option("--write", file, "the document whose table gets the rows of the cases that were run");
    CLI11_PARSE(app, argc, argv);

    try {
        std::optional<imbibe::bench::Document> document;
        if (!file.empty())
            document.emplace(file, "validation");
        for (Case c : cases) {
            if (std::find(chosen.begin(), chosen.end(), "all") == chosen.end() &&
                std::find(chosen.begin(), chosen.end(), c.name) == chosen.end())
                continue;
            if (!resolutions.empty())
                c.resolutions = resolutions;
            const std::string rows = table_rows(c);
            std::printf("%s", rows.c_str());
            std::fflush(stdout);
            if (document)
                replace_rows(*document, c.name, rows);
        }
    } catch (const imbibe::Error& error) {
        std::fprintf(stderr, "validation: %s\n", error.what());
        return 2;
    }
    return 0;
}
