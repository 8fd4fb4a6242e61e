// A part from an STL file in a tank of water: looked at, filled with particles that follow its surface together with
// the water round it, and loaded by the water's weight.
//
//   build/guide_part_in_water           writes out-part-in-water/part.stl first, a pyramid in millimetres
#include <imbibe/imbibe.hpp>
#include <imbibe/input/input.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace sph = imbibe;
using K = sph::WendlandC2;

struct Water : sph::Fluid<sph::LinearState, sph::WeaklyCompressible<K>, sph::MonaghanViscosity<K>> {};
struct Part : sph::Wall<> {};
struct Tank : sph::Wall<> {};
struct OnPart : sph::CouplingOf<Water, Part, sph::Into<Part, sph::ReactionForce<sph::VolumePressure<K>>>> {};
struct InTank : sph::CouplingOf<Water, Tank> {};
using Scene = sph::Solver<3, float, sph::SymplecticEuler, Water, Part, Tank, OnPart, InTank>;

void write_pyramid(const std::filesystem::path& path) { // 60 mm square, 50 mm high
    std::filesystem::create_directories(path.parent_path());
    std::ofstream file(path);
    const char* corners[] = {"-30 -30 0", "30 -30 0", "30 30 0", "-30 30 0", "0 0 50"};
    const int faces[][3] = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    file << "solid pyramid\n";
    for (const auto& face : faces) {
        file << "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
            file << "vertex " << corners[corner] << '\n';
        file << "endloop\nendfacet\n";
    }
    file << "endsolid pyramid\n";
}

int main() {
    const double dx = 4e-3, g = 9.81, depth = 0.08;
    write_pyramid("out-part-in-water/part.stl");
    const sph::TriangleMesh mesh(sph::read_mesh("out-part-in-water/part.stl", sph::millimetres));
    for (const auto& sentence : sph::mesh_report(mesh, dx).sentences)
        std::printf("%s\n", sentence.c_str());

    const auto part = sph::translated(mesh, {0, 0, 0.012});
    const sph::Box<3> water{{-0.06, -0.06, 0}, {0.06, 0.06, depth}};
    const auto placed = sph::fitted_together(dx, water.lower(), 0, part, water - part);

    Scene scene({.gravity = {0, 0, -g}, .support_radius = 2.6 * dx});
    const auto pool = scene.add(Water{{.density = 1000, .sound_speed = 10}}, placed[1], dx);
    const auto body = scene.add(Part{{.density = 1000}}, placed[0], dx);
    scene.add(Tank{{.density = 1000}}, sph::tank(water, dx, 3, sph::Sides::z_high), dx);
    sph::start_hydrostatic(scene, pool, depth);
    scene.run_until(0.02);

    const double lift = scene[body][sph::reaction_force].cast<double>().col(2).sum();
    const double weight = 1000 * g * mesh.volume(); // of the water in its place (Archimedes)
    std::printf("%d particles for a volume of %.3g m^3; lift %.3f N, the weight of its water %.3f N\n",
                scene[body].size(), mesh.volume(), lift, weight);
    return std::abs(scene[body].size() * dx * dx * dx / mesh.volume() - 1) < 0.02 && std::abs(lift / weight - 1) < 0.1
               ? 0
               : 1;
}
