// Images in voxels from raw, npy, NRRD, MetaImage, NIfTI-1, TIFF and VTI files, and what is said of damaged ones.
#include "bytes_of.hpp"

#include <catch_shim.hpp>

#include <imbibe/input/read_image.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace read_image_test {

using namespace imbibe;
using imbibe_test::contains;
using input_test::append;

namespace {

/// 3 x 2 x 2 voxels, each with a value that tells where it is.
constexpr int nx = 3, ny = 2, nz = 2;
constexpr int value_of(int x, int y, int z) {
    return 1 + x + 10 * y + 100 * z;
}
template <class T>
std::string voxels(Fastest fastest = Fastest::x, bool little = true) {
    std::string bytes;
    if (fastest == Fastest::x) {
        for (int z = 0; z < nz; ++z)
            for (int y = 0; y < ny; ++y)
                for (int x = 0; x < nx; ++x)
                    append<T>(bytes, static_cast<T>(value_of(x, y, z)), little);
    } else {
        for (int x = 0; x < nx; ++x)
            for (int y = 0; y < ny; ++y)
                for (int z = 0; z < nz; ++z)
                    append<T>(bytes, static_cast<T>(value_of(x, y, z)), little);
    }
    return bytes;
}
void check(const GreyImage& image) {
    REQUIRE(image.size == std::array<int, 3>{nx, ny, nz});
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                CHECK(image.at(x, y, z) == static_cast<float>(value_of(x, y, z)));
}

std::string npy(const std::string& type, const std::string& shape, const std::string& fortran,
                const std::string& data) {
    std::string head = "{'descr': '" + type + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
    while ((10 + head.size() + 1) % 64 != 0)
        head += ' ';
    head += '\n';
    std::string bytes = "\x93NUMPY";
    append<std::uint8_t>(bytes, 1), append<std::uint8_t>(bytes, 0);
    append<std::uint16_t>(bytes, static_cast<std::uint16_t>(head.size()));
    return bytes + head + data;
}

std::string nrrd(const std::string& more = "") {
    return "NRRD0004\n# a comment: of no use\ntype: unsigned short\ndimension: 3\nsizes: 3 2 2\nendian: big\n"
           "encoding: raw\nspacings: 1 1 2\n" +
           more + "\n" + voxels<std::uint16_t>(Fastest::x, false);
}

std::string mha(const std::string& file = "LOCAL") {
    return "ObjectType = Image\nNDims = 3\nBinaryDataByteOrderMSB = False\nCompressedData = False\nDimSize = 3 2 2\n"
           "ElementSpacing = 0.5 0.5 0.5\nElementType = MET_SHORT\nElementDataFile = " +
           file + "\n";
}

std::string nifti(bool little = true) {
    std::string bytes;
    append<std::int32_t>(bytes, 348, little);
    bytes.resize(40, '\0');
    for (const int n : {3, nx, ny, nz, 1, 1, 1, 1})
        append<std::int16_t>(bytes, static_cast<std::int16_t>(n), little);
    bytes.resize(70, '\0');
    append<std::int16_t>(bytes, 4, little); // int16
    bytes.resize(76, '\0');
    for (int k = 0; k < 8; ++k)
        append<float>(bytes, 0.25f, little);
    append<float>(bytes, 352, little);
    append<float>(bytes, 2, little); // the values are stored as (value - 1)/2
    append<float>(bytes, 1, little);
    bytes.resize(344, '\0');
    bytes += "n+1";
    bytes.resize(352, '\0');
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                append<std::int16_t>(bytes, static_cast<std::int16_t>(2 * value_of(x, y, z)), little);
    return bytes;
}

/// Two pages, each in one strip behind its directory.
std::string tiff(bool little, std::uint16_t bits, std::uint16_t compression = 1) {
    std::string bytes = little ? "II" : "MM";
    append<std::uint16_t>(bytes, 42, little);
    append<std::uint32_t>(bytes, 8, little);
    for (int z = 0; z < nz; ++z) {
        const std::size_t directory = bytes.size(), entries = 7;
        const std::size_t data = directory + 2 + 12 * entries + 4;
        append<std::uint16_t>(bytes, static_cast<std::uint16_t>(entries), little);
        const auto entry = [&](std::uint16_t tag, std::uint32_t value) {
            append<std::uint16_t>(bytes, tag, little);
            append<std::uint16_t>(bytes, 4, little);
            append<std::uint32_t>(bytes, 1, little);
            append<std::uint32_t>(bytes, value, little);
        };
        entry(256, nx), entry(257, ny), entry(258, bits), entry(259, compression);
        entry(262, 1), entry(273, static_cast<std::uint32_t>(data)), entry(278, ny);
        std::string page;
        for (int y = 0; y < ny; ++y) {
            if (bits == 1)
                page += static_cast<char>(y == 0 ? 0xa0 : 0x40); // 1 0 1 and 0 1 0
            for (int x = 0; x < nx && bits > 1; ++x) {
                if (bits == 8)
                    append<std::uint8_t>(page, static_cast<std::uint8_t>(value_of(x, y, z)), little);
                else
                    append<std::uint16_t>(page, static_cast<std::uint16_t>(value_of(x, y, z)), little);
            }
        }
        if (page.size() % 2 != 0)
            page += '\0';
        append<std::uint32_t>(bytes, z + 1 < nz ? static_cast<std::uint32_t>(data + page.size()) : 0, little);
        bytes += page;
    }
    return bytes;
}

std::string vti(const std::string& where = "CellData", const std::string& extent = "0 3 0 2 0 2") {
    std::string bytes = "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" "
                        "header_type=\"UInt64\">\n<ImageData WholeExtent=\"" +
                        extent + "\" Origin=\"0 0 0\" Spacing=\"2 2 2\">\n<Piece Extent=\"" + extent + "\">\n<" +
                        where + ">\n<DataArray type=\"Float32\" Name=\"grey\" format=\"appended\" offset=\"0\"/>\n</" +
                        where + ">\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_";
    append<std::uint64_t>(bytes, 4 * nx * ny * nz);
    return bytes + voxels<float>() + "\n</AppendedData>\n</VTKFile>\n";
}

std::string replaced(std::string bytes, const std::string& what, const std::string& by) {
    return bytes.replace(bytes.find(what), what.size(), by);
}

} // namespace

TEST_CASE("Read image: a file without a head, of every type, in both orders of bytes and axes") {
    const std::array<int, 3> size{nx, ny, nz};
    check(parse_raw(voxels<std::uint8_t>(), size, SampleType::uint8, Fastest::x));
    check(parse_raw(voxels<std::uint16_t>(), size, SampleType::uint16, Fastest::x));
    check(parse_raw(voxels<std::int16_t>(Fastest::z), size, SampleType::int16, Fastest::z));
    check(parse_raw(voxels<std::uint32_t>(Fastest::x, false), size, SampleType::uint32, Fastest::x, false));
    check(parse_raw(voxels<std::int32_t>(), size, SampleType::int32, Fastest::x));
    check(parse_raw(voxels<float>(Fastest::z, false), size, SampleType::float32, Fastest::z, false));
    check(parse_raw(voxels<double>(), size, SampleType::float64, Fastest::x));
    CHECK(parse_raw(std::string(1, '\xff'), {1, 1, 1}, SampleType::int8, Fastest::x).at(0, 0, 0) == -1);
    CHECK_THROWS_WITH(parse_raw(voxels<std::uint8_t>(), size, SampleType::uint16, Fastest::x, true, "a.raw"),
                      contains("a.raw") && contains("12 bytes") && contains("24"));
    CHECK_THROWS_WITH(parse_raw(voxels<std::uint16_t>(), size, SampleType::uint8, Fastest::x), contains("24 bytes"));
    CHECK_THROWS_WITH(parse_raw("", {0, 1, 1}, SampleType::uint8, Fastest::x), contains("0 x 1 x 1"));
}

TEST_CASE("Read image: numpy's arrays, indexed either way, in either order") {
    check(parse_npy(npy("<u2", "(2, 2, 3)", "False", voxels<std::uint16_t>()), Fastest::x));
    check(parse_npy(npy(">f8", "(3, 2, 2)", "False", voxels<double>(Fastest::z, false)), Fastest::z));
    check(parse_npy(npy("|u1", "(3, 2, 2)", "True", voxels<std::uint8_t>()), Fastest::x));
    CHECK_THROWS_WITH(parse_npy("nothing of this kind", Fastest::x), contains("numpy"));
    CHECK_THROWS_WITH(parse_npy(npy("<c16", "(2, 2, 3)", "False", ""), Fastest::x), contains("\"<c16\""));
    CHECK_THROWS_WITH(parse_npy(npy("<u2", "(2, 2)", "False", ""), Fastest::x), contains("three whole numbers"));
    CHECK_THROWS_WITH(parse_npy(npy("<u2", "(2, 2, 3)", "False", "short"), Fastest::x), contains("cut off"));
}

TEST_CASE("Read image: NRRD, MetaImage, NIfTI-1, TIFF and VTI") {
    const GreyImage from_nrrd = parse_nrrd(nrrd());
    check(from_nrrd);
    CHECK(from_nrrd.sides == Point<3>(1, 1, 2));

    const std::string whole = mha() + voxels<std::int16_t>();
    check(parse_meta_image(parse_meta_image_head(whole), whole));
    check(parse_meta_image(parse_meta_image_head(mha("grey.raw")), voxels<std::int16_t>()));
    const MetaImageHead behind = parse_meta_image_head(replaced(mha("grey.raw"), "NDims", "HeaderSize = -1\nNDims"));
    check(parse_meta_image(behind, "something before" + voxels<std::int16_t>()));

    for (const bool little : {true, false}) {
        const auto scaled = parse_nifti(nifti(little));
        CHECK(scaled.sides == Point<3>(0.25, 0.25, 0.25));
        REQUIRE(scaled.size == std::array<int, 3>{nx, ny, nz});
        CHECK(scaled.at(2, 1, 1) == 2 * (2.0f * value_of(2, 1, 1)) + 1);
        check(parse_tiff(tiff(little, 8)));
        check(parse_tiff(tiff(little, 16)));
        const GreyImage bits = parse_tiff(tiff(little, 1));
        CHECK(bits.at(0, 0, 0) + bits.at(2, 0, 1) + bits.at(1, 1, 1) == 3);
        CHECK(bits.at(1, 0, 0) + bits.at(0, 1, 0) + bits.at(2, 1, 0) == 0);
    }
    check(parse_vti(vti()));
    check(parse_vti(vti("PointData", "0 2 0 1 0 1")));
    CHECK(parse_vti(vti()).sides == Point<3>(2, 2, 2));
}

TEST_CASE("Read image: what is compressed, cut off or of another kind is refused with the reason") {
    CHECK_THROWS_WITH(parse_nrrd(replaced(nrrd(), "encoding: raw", "encoding: gzip")), contains("\"gzip\""));
    CHECK_THROWS_WITH(parse_nrrd(nrrd("data file: other.raw\n")), contains("another file"));
    CHECK_THROWS_WITH(parse_nrrd(replaced(nrrd(), "unsigned short", "block")), contains("\"block\""));
    CHECK_THROWS_WITH(parse_nrrd("NRRD0004\ntype: uchar\n"), contains("no end"));
    CHECK_THROWS_WITH(parse_nrrd("NRRD0004\ntype: uchar\n\n"), contains("sizes"));
    CHECK_THROWS_WITH(parse_meta_image_head(replaced(mha(), "CompressedData = False", "CompressedData = True")),
                      contains("compressed"));
    CHECK_THROWS_WITH(parse_meta_image_head(replaced(mha(), "NDims = 3", "NDims = 2")), contains("dimensions"));
    CHECK_THROWS_WITH(parse_meta_image_head("nothing"), contains("ElementDataFile"));
    CHECK_THROWS_WITH(parse_meta_image(parse_meta_image_head(mha("a.raw")), "short"), contains("cut off"));
    CHECK_THROWS_WITH(parse_nifti(std::string(400, 'x')), contains("348"));
    CHECK_THROWS_WITH(parse_nifti("\x1f\x8b" + std::string(400, 'x')), contains("gunzip"));
    CHECK_THROWS_WITH(parse_nifti(nifti().substr(0, 360)), contains("cut off"));
    CHECK_THROWS_WITH(parse_tiff("text"), contains("TIFF"));
    CHECK_THROWS_WITH(parse_tiff(tiff(true, 8, 5)), contains("compressed (kind 5)"));
    CHECK_THROWS_WITH(parse_tiff(tiff(true, 16).substr(0, 110)), contains("cut off"));
    CHECK_THROWS_WITH(parse_tiff(tiff(true, 12)), contains("12 bits"));
    std::string circle = tiff(true, 8);
    circle.replace(8 + 2 + 12 * 7, 4, std::string("\x08\0\0\0", 4)); // the second page is the first again
    CHECK_THROWS_WITH(parse_tiff(circle), contains("cut off"));
    CHECK_THROWS_WITH(parse_vti(replaced(vti(), "\"raw\"", "\"base64\"")), contains("\"base64\""));
    CHECK_THROWS_WITH(parse_vti(replaced(vti(), "ImageData", "PolyData")), contains("\"PolyData\""));
    CHECK_THROWS_WITH(parse_vti(replaced(vti(), "format=\"appended\"", "format=\"ascii\"")), contains("\"ascii\""));
    CHECK_THROWS_WITH(parse_vti("<xml>"), contains("VTKFile"));
}

TEST_CASE("Read image: a file is read by its ending, and the voxels beside a head are found") {
    const auto folder = std::filesystem::temp_directory_path() / "imbibe_read_image_test";
    std::filesystem::create_directories(folder);
    const auto write = [&](const std::string& name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
        return folder / name;
    };
    check(read_image(write("a.nrrd", nrrd())));
    check(read_image(write("a.mha", mha() + voxels<std::int16_t>())));
    write("grey.raw", voxels<std::int16_t>());
    check(read_image(write("a.mhd", mha("grey.raw"))));
    check(read_image(write("a.TIF", tiff(true, 8))));
    check(read_image(write("a.vti", vti())));
    check(read_raw(folder / "grey.raw", {nx, ny, nz}, SampleType::int16, Fastest::x));
    check(read_npy(write("a.npy", npy("<u2", "(2, 2, 3)", "False", voxels<std::uint16_t>())), Fastest::x));
    CHECK_THROWS_WITH(read_image(folder / "a.npy"), contains("read_npy()"));
    CHECK_THROWS_WITH(read_image(folder / "none.tif"), contains("cannot be opened"));
    CHECK_THROWS_WITH(read_image(write("b.mhd", mha("gone.raw"))), contains("gone.raw"));
    std::filesystem::remove_all(folder);
}

} // namespace read_image_test
