// Any bytes as a compressed image: they are read or refused with an Error. As fuzz_image.cpp, with zlib.
//
// The first byte chooses the kind of file, and whether the rest is packed by zlib first.
#include <imbibe/input/read_compressed_image.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

namespace sph = imbibe;

std::string packed(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string result(size, '\0');
    if (compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                 static_cast<uLong>(bytes.size())) != Z_OK)
        std::abort();
    result.resize(size);
    return result;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::string rest(reinterpret_cast<const char*>(data) + 1, size - 1);
    const bool well_packed = (data[0] & 4) != 0;
    const std::string bytes = well_packed ? packed(rest) : rest;
    try {
        switch (data[0] & 3) {
        case 0:
            if (sph::unpack(bytes) != rest && well_packed)
                std::abort();
            break;
        case 1:
            static_cast<void>(sph::parse_nrrd(sph::detail::unpacked_nrrd(
                "NRRD0004\ntype: uchar\ndimension: 3\nencoding: gzip\nsizes: 2 3 1\n\n" + bytes, "fuzz")));
            break;
        case 2: // one block of the size that it has
            static_cast<void>(sph::parse_vti(sph::detail::unpacked_vti(
                "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\">"
                "<ImageData WholeExtent=\"0 2 0 3 0 1\"><CellData><DataArray type=\"UInt8\" format=\"appended\" "
                "offset=\"0\"/></CellData><AppendedData encoding=\"raw\">_" +
                    std::string("\1\0\0\0\6\0\0\0\0\0\0\0", 12) + static_cast<char>(bytes.size() & 127) +
                    std::string(3, '\0') + bytes,
                "fuzz")));
            break;
        default:
            static_cast<void>(sph::parse_vti(sph::detail::unpacked_vti(
                "<VTKFile type=\"ImageData\" byte_order=\"LittleEndian\" compressor=\"vtkZLibDataCompressor\">" + bytes,
                "fuzz")));
        }
    } catch (const sph::Error&) {
    }
    return 0;
}
