// Compressed images: gzip, zlib, and what libtiff reads; each gives the same voxels as the file that is not compressed.
#include "bytes_of.hpp"

#include <catch_shim.hpp>

#include <imbibe/input/read_compressed_image.hpp>
#include <imbibe/input/read_tiff.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace read_compressed_test {

using namespace imbibe;
using imbibe_test::contains;
using input_test::append;

namespace {

constexpr std::array<int, 3> size{5, 4, 3};
int value_of(int x, int y, int z) {
    return 1 + x + 10 * y + 60 * z;
}
std::string voxels() {
    std::string bytes;
    for (int z = 0; z < size[2]; ++z)
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x)
                append<std::uint8_t>(bytes, static_cast<std::uint8_t>(value_of(x, y, z)));
    return bytes;
}
void check(const GreyImage& image) {
    REQUIRE(image.size == size);
    for (int z = 0; z < size[2]; ++z)
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x)
                CHECK(image.at(x, y, z) == static_cast<float>(value_of(x, y, z)));
}

/// Packed by zlib, with its own head or with gzip's.
std::string packed(const std::string& bytes, bool gzip) {
    z_stream stream{};
    REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY) == Z_OK);
    std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())) + 100, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
    result.resize(result.size() - stream.avail_out);
    deflateEnd(&stream);
    return result;
}

struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / "imbibe-compressed-images";
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
        return path / name;
    }
};

std::string nifti() {
    std::string head;
    append<std::int32_t>(head, 348);
    head.resize(40, '\0');
    for (const int n : {3, size[0], size[1], size[2], 1, 1, 1, 1})
        append<std::int16_t>(head, static_cast<std::int16_t>(n));
    head.resize(70, '\0');
    append<std::int16_t>(head, 2);
    head.resize(108, '\0');
    append<float>(head, 352);
    head.resize(344, '\0');
    head += std::string("n+1\0", 4);
    head.resize(352, '\0');
    return head + voxels();
}

/// A VTK file with its voxels in two blocks.
std::string vti() {
    const std::string all = voxels(), first = packed(all.substr(0, 40), false), second = packed(all.substr(40), false);
    std::string bytes =
        "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" header_type=\"UInt32\" "
        "compressor=\"vtkZLibDataCompressor\">\n<ImageData WholeExtent=\"0 5 0 4 0 3\" Spacing=\"1 1 2\">"
        "<CellData><DataArray type=\"UInt8\" format=\"appended\" offset=\"4\"/></CellData></ImageData>"
        "<AppendedData encoding=\"raw\">_0000";
    for (const std::size_t n : {std::size_t{2}, std::size_t{40}, std::size_t{20}, first.size(), second.size()})
        append<std::uint32_t>(bytes, static_cast<std::uint32_t>(n));
    return bytes + first + second + "</AppendedData></VTKFile>";
}

void write_tiff(const std::filesystem::path& path, std::uint16_t compression, bool tiled) {
    TIFF* const file = TIFFOpen(path.string().c_str(), "w");
    REQUIRE(file != nullptr);
    for (int z = 0; z < size[2]; ++z) {
        TIFFSetField(file, TIFFTAG_IMAGEWIDTH, size[0]);
        TIFFSetField(file, TIFFTAG_IMAGELENGTH, size[1]);
        TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 16);
        TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(file, TIFFTAG_COMPRESSION, compression);
        std::vector<std::uint16_t> block(tiled ? 16 * 16 : 5 * 4);
        for (int y = 0; y < size[1]; ++y)
            for (int x = 0; x < size[0]; ++x)
                block[static_cast<std::size_t>(y * (tiled ? 16 : 5) + x)] =
                    static_cast<std::uint16_t>(value_of(x, y, z));
        const auto bytes = static_cast<tmsize_t>(2 * block.size());
        if (tiled) {
            TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
            TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
            REQUIRE(TIFFWriteEncodedTile(file, 0, block.data(), bytes) == bytes);
        } else {
            TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 4);
            REQUIRE(TIFFWriteEncodedStrip(file, 0, block.data(), bytes) == bytes);
        }
        REQUIRE(TIFFWriteDirectory(file) == 1);
    }
    TIFFClose(file);
}

} // namespace

TEST_CASE("Compressed images: NIfTI, NRRD, MetaImage and VTI have the voxels that were packed") {
    const Folder folder;
    check(read_compressed_image(folder.write("a.nii.gz", packed(nifti(), true))));
    const std::string nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 5 4 3\nencoding: gzip\n\n";
    check(read_compressed_image(folder.write("a.nrrd", nrrd + packed(voxels(), true))));
    const std::string meta = "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nCompressedData = True\n"
                             "CompressedDataSize = 60\nElementDataFile = ";
    check(read_compressed_image(folder.write("a.mha", meta + "LOCAL\n" + packed(voxels(), false))));
    folder.write("a.zraw", packed(voxels(), false));
    check(read_compressed_image(folder.write("a.mhd", meta + "a.zraw\n")));
    const GreyImage from_vti = read_compressed_image(folder.write("a.vti", vti()));
    check(from_vti);
    CHECK(from_vti.sides == Point<3>(1, 1, 2));
}

TEST_CASE("Compressed images: those that are not compressed are read as ever") {
    const Folder folder;
    check(read_compressed_image(folder.write("a.nii", nifti())));
    check(read_compressed_image(
        folder.write("a.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 5 4 3\nencoding: raw\n\n" + voxels())));
    check(read_compressed_image(folder.write(
        "a.mha", "NDims = 3\nDimSize = 5 4 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + voxels())));
}

TEST_CASE("Compressed images: damage is named") {
    const Folder folder;
    const std::string whole = packed(nifti(), true);
    CHECK_THROWS_WITH(read_compressed_image(folder.write("a.nii.gz", whole.substr(0, whole.size() - 20))),
                      contains("cut off"));
    std::string damaged = whole;
    damaged[20] = static_cast<char>(damaged[20] ^ 0x55);
    CHECK_THROWS_WITH(read_compressed_image(folder.write("a.nii.gz", damaged)), contains("damaged"));
    CHECK_THROWS_WITH(read_compressed_image(folder.write("a.tif.gz", whole)), contains("\".tif.gz\""));
    CHECK_THROWS_WITH(unpack("no packed data"), contains("damaged"));
    CHECK_THROWS_WITH(unpack(""), contains("cut off"));
    std::string other = vti();
    other.replace(other.find("vtkZLibDataCompressor"), 21, "vtkLZ4DataCompressor");
    CHECK_THROWS_WITH(read_compressed_image(folder.write("a.vti", other)), contains("something else than zlib"));
    CHECK_THROWS_WITH(read_compressed_image(folder.write("b.vti", vti().substr(0, vti().size() - 60))),
                      contains("cut off"));
}

TEST_CASE("TIFF: libtiff reads every compression, and tiles") {
    const Folder folder;
    for (const bool tiled : {false, true})
        for (const int compression :
             {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
            const auto path = folder.path / "a.tif";
            write_tiff(path, static_cast<std::uint16_t>(compression), tiled);
            check(read_tiff(path));
        }
    CHECK_THROWS_WITH(read_tiff(folder.path / "not.tif"), contains("cannot be opened"));
    CHECK_THROWS_WITH(read_tiff(folder.write("text.tif", "no image")), contains("no TIFF file"));
    write_tiff(folder.path / "a.tif", COMPRESSION_LZW, false);
    std::filesystem::resize_file(folder.path / "a.tif", 20);
    CHECK_THROWS_AS(read_tiff(folder.path / "a.tif"), Error);
}

} // namespace read_compressed_test
