// A soft open foam is squeezed, and its permeability measured again: what a solver on fixed voxels cannot do.
//
// One periodic cell of a gyroid of rubber; the mean strain is along z, nothing moves sideways. At each strain the body
// is packed anew with liquid in its pores. Beside k stands what Kozeny and Carman make of the porosity alone,
// k ~ p^3/(1 - p)^2. Struts that meet pass through each other: from there on the last rows are too dense.
//
//   build/squeezed_foam                 0.2 of it solid, 24 particles along the cell
//   build/squeezed_foam 0.3 32          0.3 of it, 32 particles; a multiple of 8
//   python3 tools/plot_curves.py squeezed-foam.csv --x strain -o squeezed_foam.png
#include "support/arguments.hpp"
#include "support/quiet_waiting.hpp"

#include <imbibe/geometry/particle_image.hpp>
#include <imbibe/geometry/triply_periodic.hpp>
#include <imbibe/porous/elastic_moduli.hpp>
#include <imbibe/porous/permeability.hpp>

#include <cmath>
#include <cstdio>
#include <fstream>

namespace sph = imbibe;

int main(int, char** argv) {
    sph::example::sleep_while_waiting(argv);
    try {
        const double share = sph::example::number(argv, 1, "the solid fraction", 0.2, 0.1, 0.6);
        const double across = sph::example::number(argv, 2, "the number of particles along the cell", 24, 16, 256);
        sph::require(std::fmod(across, 8) == 0, across, " particles along the cell; it must be a multiple of 8.");
        const double cell = 1e-3, dx = cell / across;
        const auto foam = sph::gyroid({{0, 0, 0}, {cell, cell, cell}}, cell, share);
        const auto box = foam.bounds();

        const auto moduli = sph::elastic_moduli(foam, dx);
        std::printf("Young's modulus %.4f +- %.4f of the rubber's; Poisson's ratio %.3f; Gibson and Ashby: (1 - p)^2 = "
                    "%.4f\n",
                    moduli.young(2), moduli.error(2, 2), moduli.poisson(2, 0), sph::sq(1 - moduli.porosity));

        const auto body = sph::fitted_together(dx, box.lower(), 0, foam, box - foam)[0];
        std::ofstream table("squeezed-foam.csv");
        sph::require(table.good(), "squeezed-foam.csv cannot be written in this folder. Go to one that can be.");
        table << "strain,along z [k_0],along x [k_0],Kozeny and Carman [k_0],stress [E]\n";
        double first = 0, first_porosity = 0;
        for (int step = 0; step <= 4; ++step) {
            const double strain = step / 8.0;
            Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
            gradient(2, 2) = -strain;
            const auto squeezed = sph::strained(body, box, dx, gradient, {.left = 3e-3});
            const auto shape =
                sph::body_of_particles(squeezed.body, {{0, 0, 0}, {cell, cell, (1 - strain) * cell}}, dx);
            const auto along = sph::permeability(shape, dx, 2), sideways = sph::permeability(shape, dx, 0);
            const double p = along.porosity;
            if (step == 0) {
                first = along.column[2];
                first_porosity = p;
            }
            const double carman = sph::power<3>(p / first_porosity) * sph::sq((1 - first_porosity) / (1 - p));
            std::printf("strain %.3f: porosity %.3f, k along %.3g +- %.1g m^2, across %.3g +- %.1g m^2, stress %.4f\n",
                        strain, p, along.column[2], along.error, sideways.column[0], sideways.error,
                        squeezed.stress(2, 2));
            table << strain << ',' << along.column[2] / first << ',' << sideways.column[0] / first << ',' << carman
                  << ',' << -squeezed.stress(2, 2) << '\n'
                  << std::flush;
        }
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "squeezed_foam: %s\n", error.what());
        return 2;
    }
}
