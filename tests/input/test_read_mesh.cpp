// Meshes from STL, OBJ and PLY files, and what is said of files that are damaged.
#include "bytes_of.hpp"

#include <catch_shim.hpp>

#include <imbibe/input/read_mesh.hpp>

#include <filesystem>
#include <fstream>
#include <string>

namespace read_mesh_test {

using namespace imbibe;
using imbibe_test::contains;
using input_test::append;

namespace {

/// A tetrahedron with edges of 2 along the axes: its corners, and its faces from outside.
constexpr float corners[4][3] = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string binary_stl(const std::string& head = "made by a test") {
    std::string bytes = head;
    bytes.resize(80, ' ');
    append<std::uint32_t>(bytes, 4);
    for (const auto& face : faces) {
        for (int k = 0; k < 3; ++k)
            append<float>(bytes, 0);
        for (const int corner : face)
            for (const float x : corners[corner])
                append<float>(bytes, x);
        append<std::uint16_t>(bytes, 7); // some programs keep a colour here
    }
    return bytes;
}

std::string text_stl(const std::string& newline = "\n") {
    std::string text = "solid part" + newline;
    for (const auto& face : faces) {
        text += "  facet normal 0 0 1" + newline + "    outer loop" + newline;
        for (const int corner : face)
            text += "      vertex " + std::to_string(corners[corner][0]) + " " + std::to_string(corners[corner][1]) +
                    "\t" + std::to_string(corners[corner][2]) + newline;
        text += "    endloop" + newline + "  endfacet" + newline;
    }
    return text + "endsolid part" + newline;
}

const std::string obj = "# a tetrahedron\nmtllib some.mtl\nv 0 0 0\nv 2 0 0 1.0\nv 0 2 0\nv 0 0 2e0\nvt 0 0\n"
                        "f 1/1 3/1/2 2//3\nf 1 2 4\nf -4 -1 -2\nf 2 3 4\n";

const std::string text_ply = "ply\nformat ascii 1.0\ncomment of no use\nelement vertex 4\nproperty float x\n"
                             "property float y\nproperty uchar red\nproperty float z\nelement face 4\n"
                             "property list uchar int vertex_indices\nelement edge 1\nproperty int a\nend_header\n"
                             "0 0 9 0\n2 0 9 0\n0 2 9 0\n0 0 9 2\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n5\n";

std::string binary_ply(bool little) {
    std::string bytes = "ply\r\nformat binary_" + std::string(little ? "little" : "big") +
                        "_endian 1.0\r\nelement vertex 4\r\nproperty double x\r\nproperty double y\r\n"
                        "property float z\r\nelement face 4\r\nproperty uchar flags\r\n"
                        "property list uchar uint vertex_index\r\nend_header\r\n";
    for (const auto& corner : corners) {
        append<double>(bytes, corner[0], little);
        append<double>(bytes, corner[1], little);
        append<float>(bytes, corner[2], little);
    }
    for (const auto& face : faces) {
        append<std::uint8_t>(bytes, 0, little);
        append<std::uint8_t>(bytes, 3, little);
        for (const int corner : face)
            append<std::uint32_t>(bytes, static_cast<std::uint32_t>(corner), little);
    }
    return bytes;
}

/// Of the tetrahedron, when one unit of the file is a millimetre: 8/6 mm^3.
void check_tetrahedron(const Triangles& mesh) {
    REQUIRE(mesh.triangles.size() == 4);
    MeshDamage damage;
    const Triangles mended = mend(mesh, &damage);
    CHECK(mended.corners.size() == 4);
    CHECK(damage.open_edges == 0);
    CHECK(damage.flipped == 0);
    CHECK(damage.inside_out == 0);
    CHECK(TriangleMesh(mesh).volume() == Approx(8e-9 / 6));
}

std::string without_end(const std::string& bytes, std::size_t cut) {
    return bytes.substr(0, bytes.size() - cut);
}

} // namespace

TEST_CASE("Read mesh: a tetrahedron comes the same out of every kind of file") {
    check_tetrahedron(parse_stl(binary_stl(), millimetres));
    check_tetrahedron(parse_stl(binary_stl("solid in binary, as some programs write"), millimetres));
    check_tetrahedron(parse_stl(text_stl(), millimetres));
    check_tetrahedron(parse_stl(text_stl("\r\n"), millimetres));
    check_tetrahedron(parse_obj(obj, millimetres));
    check_tetrahedron(parse_ply(text_ply, millimetres));
    check_tetrahedron(parse_ply(binary_ply(true), millimetres));
    check_tetrahedron(parse_ply(binary_ply(false), millimetres));
}

TEST_CASE("Read mesh: faces of more than three corners become triangles") {
    const std::string cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                             "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    const Triangles mesh = parse_obj(cube, metres);
    CHECK(mesh.triangles.size() == 12);
    CHECK(TriangleMesh(mesh).volume() == Approx(1));
}

TEST_CASE("Read mesh: a file is read by its ending, and its unit counts") {
    const auto folder = std::filesystem::temp_directory_path() / "imbibe_read_mesh_test";
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    };
    check_tetrahedron(read_mesh(write("a.STL", binary_stl()), millimetres));
    check_tetrahedron(read_mesh(write("a.obj", obj), millimetres));
    check_tetrahedron(read_mesh(write("a.ply", text_ply), millimetres));
    CHECK(TriangleMesh(read_mesh(folder / "a.ply", inches)).volume() == Approx(8.0 / 6 * 0.0254 * 0.0254 * 0.0254));
    CHECK_THROWS_WITH(read_mesh(folder / "none.stl", metres), contains("none.stl cannot be opened"));
    CHECK_THROWS_WITH(read_mesh(write("a.step", "ISO"), metres), contains(".stl, .obj and .ply"));
    CHECK_THROWS_WITH(read_mesh(folder / "a.ply", 0), contains("unit = 0 m"));
    std::filesystem::create_directories(folder / "folder.stl");
    CHECK_THROWS_WITH(read_mesh(folder / "folder.stl", metres), contains("is a folder"));
    std::filesystem::remove_all(folder);
}

TEST_CASE("Read mesh: a damaged file is refused with the place") {
    CHECK_THROWS_WITH(parse_stl(without_end(binary_stl(), 60), metres, "gear.stl"),
                      contains("gear.stl") && contains("224 bytes") && contains("4 triangles") && contains("284"));
    CHECK_THROWS_WITH(parse_stl(text_stl().substr(0, text_stl().rfind("vertex")), metres),
                      contains("middle of a triangle"));
    CHECK_THROWS_WITH(parse_stl("solid\n vertex 1 2 x3\n", metres), contains("line 2") && contains("\"x3\""));
    CHECK_THROWS_WITH(parse_stl("solid nothing\nendsolid\n", metres), contains("no triangle"));
    CHECK_THROWS_WITH(parse_stl("", metres), contains("0 bytes"));
    CHECK_THROWS_WITH(parse_obj("v 0 0\n", metres), contains("line 1") && contains("coordinate z"));
    CHECK_THROWS_WITH(parse_obj("v 0 0 0\nv 1 0 0\nf 1 2 3\n", metres),
                      contains("line 3") && contains("\"3\"") && contains("2 vertices"));
    CHECK_THROWS_WITH(parse_obj("v 0 0 0\nv 1 0 0\nf 1 2\n", metres), contains("2 corners"));
    CHECK_THROWS_WITH(parse_obj("nothing", metres), contains("no face"));
    CHECK_THROWS_WITH(parse_ply("solid", metres), contains("no PLY"));
    CHECK_THROWS_WITH(parse_ply("ply\nformat ascii 1.0\n", metres), contains("no end"));
    CHECK_THROWS_WITH(parse_ply("ply\nend_header\n", metres), contains("format"));
    CHECK_THROWS_WITH(parse_ply("ply\nformat utf8\nend_header\n", metres), contains("\"utf8\""));
    CHECK_THROWS_WITH(parse_ply("ply\nformat ascii 1.0\nelement vertex -3\nend_header\n", metres), contains("\"-3\""));
    CHECK_THROWS_WITH(parse_ply(without_end(binary_ply(true), 6), metres), contains("cut off"));
    CHECK_THROWS_WITH(parse_ply(without_end(text_ply, 12), metres), contains("where a number should be"));
    std::string other = text_ply;
    other.replace(other.find("3 1 2 3"), 7, "3 1 2 4");
    CHECK_THROWS_WITH(parse_ply(other, metres), contains("corner 4") && contains("4 vertices"));
    other = text_ply;
    other.replace(other.find("element face 4"), 14, "element lace 4");
    CHECK_THROWS_WITH(parse_ply(other, metres), contains("cloud of points"));
}

} // namespace read_mesh_test
