// Reads compressed images: .nii.gz, and NRRD, MetaImage and VTI with compressed voxels. Needs zlib, which a program
// that includes this links (-lz; find_package(ZLIB), ZLIB::ZLIB).
#pragma once

#include <imbibe/input/read_image.hpp>

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace imbibe {

/// Decompresses gzip or zlib data. @param packed all of it @param name of the file, for messages
/// @throws Error if it is neither, damaged or cut off
[[nodiscard]] inline std::string unpack(std::string_view packed, std::string_view name = "packed data") {
    z_stream stream{};
    require(inflateInit2(&stream, 15 + 32) == Z_OK, name, ": zlib cannot begin.");
    std::string result;
    std::string block(std::size_t{1} << 15, '\0');
    int state = Z_OK;
    std::size_t taken = 0;
    while (state == Z_OK) {
        if (stream.avail_in == 0) { // zlib's counts are 32 bits wide
            const std::size_t more = std::min(packed.size() - taken, std::size_t{1} << 30);
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + taken));
            stream.avail_in = static_cast<uInt>(more);
            taken += more;
        }
        stream.next_out = reinterpret_cast<Bytef*>(block.data());
        stream.avail_out = static_cast<uInt>(block.size());
        state = inflate(&stream, Z_NO_FLUSH);
        result.append(block, 0, block.size() - stream.avail_out);
    }
    const std::string trouble = stream.msg ? stream.msg : "it is cut off";
    inflateEnd(&stream);
    require(state == Z_STREAM_END, name, ": the packed voxels are damaged: ", trouble, ". Get the file anew.");
    return result;
}

namespace detail {

inline std::string unpacked_nrrd(std::string_view bytes, std::string_view name) {
    std::string_view rest = bytes;
    std::string_view encoding;
    while (!rest.empty()) {
        const std::string_view line = next_line(rest);
        if (line.empty())
            break;
        if (line.substr(0, 9) == "encoding:")
            encoding = line;
    }
    const auto parts = split_at(encoding, ":");
    if (!parts || (parts->second != "gzip" && parts->second != "gz"))
        return std::string(bytes);
    std::string head(bytes, 0, bytes.size() - rest.size());
    head.replace(head.find(encoding), encoding.size(), "encoding: raw");
    return head + unpack(rest, name);
}

// A VTK file has compressed voxels in blocks: their number, the uncompressed size of each, that of the last if it
// differs, and the compressed sizes; then the blocks.
inline std::string unpacked_vti(std::string_view bytes, std::string_view name) {
    const auto attribute = bytes.find(" compressor=\"");
    const auto mark = bytes.find('_', bytes.find("<AppendedData"));
    if (attribute == bytes.npos || mark == bytes.npos || attribute > mark)
        return std::string(bytes);
    const std::string_view head = bytes.substr(0, mark + 1);
    require(head.find("vtkZLibDataCompressor") != head.npos, name,
            ": the voxels are packed by something else than zlib. Save the image with zlib or without compression.");
    const bool wide = head.find("header_type=\"UInt64\"") != head.npos;
    const bool little = head.find("byte_order=\"BigEndian\"") == head.npos;
    const std::size_t each = wide ? 8 : 4;
    const auto array = head.find("<DataArray");
    const auto offset_at = head.find(" offset=\"", array == head.npos ? 0 : array);
    require(offset_at != head.npos, name, ": it is not said where the voxels begin.");
    const std::string_view offset_text = head.substr(offset_at + 9);
    const auto offset = whole_number_of(offset_text.substr(0, offset_text.find('"')));
    require(offset && *offset >= 0 && static_cast<std::size_t>(*offset) < bytes.size() - mark, name,
            ": it is not said where the voxels begin.");
    std::size_t at = mark + 1 + static_cast<std::size_t>(*offset);
    const auto next_number = [&] {
        require(at + each <= bytes.size(), name, ": the file ends before all of it is there. It is cut off.");
        const std::size_t number = wide ? static_cast<std::size_t>(number_at<std::uint64_t>(bytes, at, little))
                                        : number_at<std::uint32_t>(bytes, at, little);
        at += each;
        return number;
    };
    const std::size_t blocks = next_number();
    next_number();
    next_number();
    require(blocks <= (bytes.size() - at) / each, name, ": the voxels are said to be in ", blocks, " blocks.");
    std::size_t block = at + each * blocks;
    std::string voxels;
    for (std::size_t k = 0; k < blocks; ++k) {
        const std::size_t size = next_number();
        require(size <= bytes.size() - block, name, ": the file ends before all of it is there. It is cut off.");
        voxels += unpack(bytes.substr(block, size), name);
        block += size;
    }
    // The same file without a compressor: the length, which nothing reads, stands in place of the numbers of the
    // blocks.
    std::string result(head);
    result.erase(attribute, head.find('"', attribute + 13) + 1 - attribute);
    result.append(static_cast<std::size_t>(*offset) + each, '\0');
    return result + voxels;
}

} // namespace detail

/// The grey values in a file, compressed or not, of the type given by its ending, .nii.gz, .nrrd, .mhd, .mha or .vti,
/// or one that read_image() reads. @param path the file
/// @throws Error if the file cannot be read, is damaged or of another kind
[[nodiscard]] inline GreyImage read_compressed_image(const std::filesystem::path& path) {
    constexpr const char* who = "read_compressed_image";
    const std::string kind = detail::lower_case(path.extension().string()), name = path.string();
    if (kind == ".gz") {
        const std::string inner = detail::lower_case(path.stem().extension().string());
        require(inner == ".nii", who, ": ", name, " ends with \"", inner,
                ".gz\"; of those .nii.gz is read. Unpack it: ", "gunzip.");
        return parse_nifti(unpack(detail::bytes_of_file(who, path), name), name);
    }
    if (kind == ".nrrd")
        return parse_nrrd(detail::unpacked_nrrd(detail::bytes_of_file(who, path), name), name);
    if (kind == ".vti")
        return parse_vti(detail::unpacked_vti(detail::bytes_of_file(who, path), name), name);
    if (kind != ".mhd" && kind != ".mha")
        return read_image(path);
    std::string bytes = detail::bytes_of_file(who, path);
    std::string_view rest = bytes, packed;
    while (!rest.empty()) {
        const std::string_view line = detail::next_line(rest);
        const auto parts = detail::split_at(line, "=");
        if (parts && parts->first == "CompressedData" && detail::lower_case(parts->second) == "true")
            packed = line;
        if (parts && parts->first == "ElementDataFile")
            break;
    }
    if (packed.empty())
        return read_image(path);
    std::string head(bytes, 0, bytes.size() - rest.size());
    head.replace(head.find(packed), packed.size(), "CompressedData = False");
    const MetaImageHead found = parse_meta_image_head(head, name);
    if (found.file == "LOCAL")
        return parse_meta_image(found, head + unpack(rest, name), name);
    const std::filesystem::path beside = path.parent_path() / found.file;
    return parse_meta_image(found, unpack(detail::bytes_of_file(who, beside), beside.string()), beside.string());
}

} // namespace imbibe
