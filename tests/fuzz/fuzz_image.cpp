// Any bytes as an image: they are read or refused with an Error. For clang's libFuzzer with the address and
// undefined-behaviour sanitizers:
//
//   cmake --preset fuzz && cmake --build --preset fuzz && build-fuzz/tests/fuzz_image -max_total_time=60
//
// The first byte chooses the kind of file; half of the inputs get a right beginning before them.
#include <imbibe/input/read_image.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

namespace sph = imbibe;

sph::GreyImage read(unsigned kind, const std::string& bytes) {
    const bool helped = (kind & 8) != 0;
    const auto begun = [&](const std::string& head) { return (helped ? head : std::string()) + bytes; };
    switch (kind & 7) {
    case 0:
        return sph::parse_raw(bytes, {2, 3, 1}, sph::SampleType::uint16, sph::Fastest::z);
    case 1:
        return sph::parse_npy(
            begun(std::string("\x93NUMPY\x01\0\x42\0", 10) + "{'descr': '<u2', 'fortran_order': False, 'shape': ("),
            sph::Fastest::z);
    case 2:
        return sph::parse_nrrd(begun("NRRD0004\ntype: uchar\ndimension: 3\nencoding: raw\nsizes: "));
    case 3: {
        const std::string all = begun("NDims = 3\nElementType = MET_SHORT\nElementDataFile = LOCAL\nDimSize = ");
        return sph::parse_meta_image(sph::parse_meta_image_head(all), all);
    }
    case 4: {
        std::string all = bytes;
        if (helped && all.size() >= 352) {
            all.replace(0, 4, std::string("\x5c\x01\0\0", 4));
            all.replace(344, 4, std::string("n+1\0", 4));
        }
        return sph::parse_nifti(all);
    }
    case 5:
        return sph::parse_tiff(begun(std::string("II*\0\x08\0\0\0", 8)));
    default:
        return sph::parse_vti(
            begun("<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 1 0 1 0 2\">"
                  "<CellData><DataArray type=\"UInt8\" format=\"appended\" offset=\"0\"/>"));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    try {
        const sph::GreyImage image = read(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
        double number = 1;
        for (const int n : image.size)
            number *= n;
        if (!(number >= 1) || number != static_cast<double>(image.values.size()))
            std::abort();
    } catch (const sph::Error&) {
    }
    return 0;
}
