// What a scan or a drawing of a porous body lets through: its permeability along x, y and z, with an error.
//
//   build/porous                                          a gyroid of two cells, with 32 particles across both
//   build/porous scan.tif --voxel 2.25 --threshold 128    an image with voxels of 2.25 micrometres
//   build/porous grey.raw --raw 110 110 110 --voxel 2.25 --threshold 0.5 --solid below --crop 64
//   build/porous part.stl --unit mm --across 80           a mesh in millimetres, 80 particles along its longest side
//
// The body is taken as one cell of an endless one: it should fit to itself across its sides.
#include "support/quiet_waiting.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/input/input.hpp>
#include <imbibe/porous/permeability.hpp>

#include <CLI/CLI.hpp>

namespace sph = imbibe;

template <class Shape>
void measure(const Shape& shape, double spacing, const std::vector<std::string>& report = {}) {
    for (const auto& sentence : report)
        std::printf("%s\n", sentence.c_str());
    for (int axis = 0; axis < 3; ++axis) {
        const auto found = sph::permeability(shape, spacing, axis);
        std::printf("along %c: k = %.4g m^2, +- %.2g (%.4g darcy); tortuosity %.3f, porosity %.4f\n", "xyz"[axis],
                    found.column[axis], found.error, found.column[axis] / 9.869233e-13, found.tortuosity,
                    found.porosity);
    }
}

int main(int argc, char** argv) {
    sph::example::sleep_while_waiting(argv);
    CLI::App app{"The permeability of a porous body."};
    std::string file, unit, solid = "above";
    double voxel = 0, threshold = 0;
    int across = 32, per_spacing = 2, crop = 0;
    std::vector<int> raw;
    app.add_option("file", file, "an image (.tif, .nrrd, .mhd, .nii, .vti, .raw) or a mesh (.stl, .obj, .ply)");
    app.add_option("--voxel", voxel, "side of a voxel of an image, micrometres");
    app.add_option("--threshold", threshold, "grey value between solid and pore");
    app.add_option("--solid", solid, "which grey values are solid")->check(CLI::IsMember({"above", "below"}));
    app.add_option("--raw", raw, "voxels along x, y, z of a file without a head, one byte each, x fastest")
        ->expected(3);
    app.add_option("--crop", crop, "so many voxels each way from the first corner; 0: all");
    app.add_option("--voxels-per-spacing", per_spacing, "how fine the particles are")->check(CLI::Range(1, 100));
    app.add_option("--unit", unit, "of a mesh")->check(CLI::IsMember({"m", "mm", "um", "inch"}));
    app.add_option("--across", across, "particles along the longest side, not of images")->check(CLI::Range(8, 2000));
    CLI11_PARSE(app, argc, argv);
    try {
        if (file.empty()) {
            measure(sph::gyroid({{0, 0, 0}, {2e-3, 2e-3, 2e-3}}, 1e-3, 0.4), 2e-3 / across);
        } else if (voxel > 0) {
            auto image = raw.empty()
                             ? sph::read_image(file)
                             : sph::read_raw(file, {raw[0], raw[1], raw[2]}, sph::SampleType::uint8, sph::Fastest::x);
            std::array<int, 3> size = image.size; // whole numbers of spacings
            for (int& n : size)
                n = (crop > 0 ? std::min(n, crop) : n) / per_spacing * per_spacing;
            image = sph::crop(image, {0, 0, 0}, size);
            const sph::Voxels how{.sides = sph::Point<3>::Constant(voxel * sph::micrometres),
                                  .threshold = threshold,
                                  .solid = solid == "above" ? sph::SolidIs::above : sph::SolidIs::below};
            const sph::ImageBody body(image, how);
            measure(body, per_spacing * how.sides[0], sph::image_report(body, per_spacing * how.sides[0]).sentences);
        } else {
            sph::require(!unit.empty(), "a mesh needs --unit, an image --voxel and --threshold");
            const double metres = unit == "m" ? 1 : unit == "mm" ? 1e-3 : unit == "um" ? 1e-6 : sph::inches;
            const sph::TriangleMesh mesh(sph::read_mesh(file, metres));
            const double spacing = mesh.bounds().size().maxCoeff() / across;
            measure(mesh, spacing, sph::mesh_report(mesh, spacing).sentences);
        }
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "porous: %s\n", error.what());
        return 2;
    }
}
