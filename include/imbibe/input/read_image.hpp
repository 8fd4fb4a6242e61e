// Reads grey-value images in voxels, without other libraries: raw, npy, NRRD, MetaImage, NIfTI-1, TIFF and VTI, all
// uncompressed.
#pragma once

#include <imbibe/geometry/image.hpp>
#include <imbibe/input/bytes.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace imbibe {

/// The number type of a voxel in a file.
enum class SampleType { uint8, int8, uint16, int16, uint32, int32, float32, float64 };

/// The axis that runs fastest in a file: neighbours along it are neighbours in the file. It is x for a numpy array
/// indexed [z, y, x], and z for one indexed [x, y, z], unless it is in Fortran order.
enum class Fastest { x, z };

namespace detail {

inline constexpr double most_voxels = 4e9;

constexpr std::size_t bytes_of(SampleType type) {
    switch (type) {
    case SampleType::uint8:
    case SampleType::int8:
        return 1;
    case SampleType::uint16:
    case SampleType::int16:
        return 2;
    case SampleType::float64:
        return 8;
    default:
        return 4;
    }
}

inline float sample_at(std::string_view bytes, std::size_t at, SampleType type, bool little) {
    switch (type) {
    case SampleType::uint8:
        return static_cast<float>(number_at<std::uint8_t>(bytes, at, little));
    case SampleType::int8:
        return static_cast<float>(number_at<std::int8_t>(bytes, at, little));
    case SampleType::uint16:
        return static_cast<float>(number_at<std::uint16_t>(bytes, at, little));
    case SampleType::int16:
        return static_cast<float>(number_at<std::int16_t>(bytes, at, little));
    case SampleType::uint32:
        return static_cast<float>(number_at<std::uint32_t>(bytes, at, little));
    case SampleType::int32:
        return static_cast<float>(number_at<std::int32_t>(bytes, at, little));
    case SampleType::float32:
        return number_at<float>(bytes, at, little);
    default:
        return static_cast<float>(number_at<double>(bytes, at, little));
    }
}

/// The number of voxels of an image size. Throws Error for an impossible size.
inline std::size_t voxels_of(std::string_view name, const std::array<long long, 3>& size) {
    double number = 1;
    for (const long long n : size) {
        require(n >= 1 && n <= 1000000, name, ": the image is ", size[0], " x ", size[1], " x ", size[2],
                " voxels; each must be from 1 to 1000000.");
        number *= static_cast<double>(n);
    }
    require(number <= most_voxels, name, ": the image has ", number, " voxels; at most ", most_voxels, " are allowed.");
    return static_cast<std::size_t>(number);
}

/// The voxels that begin at byte `from`, size[0] fastest.
inline GreyImage image_of(std::string_view name, std::string_view bytes, std::size_t from,
                          const std::array<long long, 3>& size, SampleType type, bool little) {
    const std::size_t number = voxels_of(name, size), each = bytes_of(type);
    require(from <= bytes.size() && number <= (bytes.size() - from) / each, name, ": the file is ", bytes.size(),
            " bytes long; ", size[0], " x ", size[1], " x ", size[2], " voxels of ", each, " bytes from byte ", from,
            " on need ", from + number * each, ". It is cut off, or size or type are others.");
    GreyImage image;
    for (std::size_t axis = 0; axis < 3; ++axis)
        image.size[axis] = static_cast<int>(size[axis]);
    image.values.resize(number);
    for (std::size_t i = 0; i < number; ++i)
        image.values[i] = sample_at(bytes, from + each * i, type, little);
    return image;
}

/// The same image if z runs fastest in the file: size along z, y, x as image_of took it.
inline GreyImage turned_round(const GreyImage& image) {
    GreyImage result;
    result.size = {image.size[2], image.size[1], image.size[0]};
    result.sides = {image.sides[2], image.sides[1], image.sides[0]};
    result.values.resize(image.values.size());
    for (int x = 0; x < result.size[0]; ++x)
        for (int y = 0; y < result.size[1]; ++y)
            for (int z = 0; z < result.size[2]; ++z)
                result.values[result.index(x, y, z)] = image.at(z, y, x);
    return result;
}

inline std::string lower_case(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// The numbers at the beginning of a line.
inline std::vector<double> numbers_in(std::string_view line) {
    std::vector<double> result;
    Words words(line);
    for (auto word = words.next(); !word.empty(); word = words.next())
        if (const auto number = number_of(word))
            result.push_back(*number);
        else
            break;
    return result;
}

inline std::array<long long, 3> size_in(std::string_view name, std::string_view line) {
    const auto numbers = numbers_in(line);
    require(numbers.size() == 3, name, ": the size is ", quoted(line), "; it must be three whole numbers.");
    std::array<long long, 3> size;
    for (std::size_t k = 0; k < 3; ++k) {
        require(numbers[k] >= 1 && numbers[k] <= 1e6, name, ": the image is ", numbers[k],
                " voxels long along one axis; from 1 to 1000000 are allowed.");
        size[k] = static_cast<long long>(numbers[k]);
    }
    return size;
}

/// The parts of a line before and behind its first `mark`, without spaces at both ends; empty without a mark.
inline std::optional<std::pair<std::string_view, std::string_view>> split_at(std::string_view line,
                                                                             std::string_view mark) {
    const auto at = line.find(mark);
    if (at == line.npos)
        return std::nullopt;
    const auto trimmed = [](std::string_view part) {
        const auto first = part.find_first_not_of(" \t\r"), last = part.find_last_not_of(" \t\r");
        return first == part.npos ? std::string_view() : part.substr(first, last - first + 1);
    };
    return std::pair{trimmed(line.substr(0, at)), trimmed(line.substr(at + mark.size()))};
}

/// Removes the next line from a text and returns it.
inline std::string_view next_line(std::string_view& rest) {
    const auto end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

} // namespace detail

/// An image without a header: nothing but voxels, one after the other.
/// @param bytes the whole file
/// @param size voxels along x, y, z
/// @param type of a voxel
/// @param fastest the axis that runs fastest
/// @param little whether the lowest byte of a number comes first
/// @param name of the file, for messages
/// @throws Error where the file has another length
[[nodiscard]] inline GreyImage parse_raw(std::string_view bytes, const std::array<int, 3>& size, SampleType type,
                                         Fastest fastest, bool little = true, std::string_view name = "raw file") {
    std::array<long long, 3> in_file{size[0], size[1], size[2]};
    if (fastest == Fastest::z)
        std::swap(in_file[0], in_file[2]);
    const GreyImage image = detail::image_of(name, bytes, 0, in_file, type, little);
    require(bytes.size() == image.values.size() * detail::bytes_of(type), name, ": the file is ", bytes.size(),
            " bytes long; ", size[0], " x ", size[1], " x ", size[2], " voxels of ", detail::bytes_of(type),
            " bytes are ", image.values.size() * detail::bytes_of(type), ". Size or type are others.");
    return fastest == Fastest::z ? detail::turned_round(image) : image;
}

/// A numpy array of three dimensions (.npy). @param bytes the whole file @param fastest the axis that runs fastest
/// @param name of the file, for messages @throws Error where it is no such file
[[nodiscard]] inline GreyImage parse_npy(std::string_view bytes, Fastest fastest, std::string_view name = "npy file") {
    require(bytes.size() >= 12 && bytes.substr(0, 6) == "\x93NUMPY", name,
            ": the file does not begin as numpy's files do.");
    const bool long_head = bytes[6] != 1;
    const std::size_t head_at = long_head ? 12 : 10;
    const std::size_t head_size =
        long_head ? detail::number_at<std::uint32_t>(bytes, 8) : detail::number_at<std::uint16_t>(bytes, 8);
    require(head_size <= bytes.size() - head_at, name, ": the file ends in its head. It is cut off.");
    const std::string_view head = bytes.substr(head_at, head_size);
    const auto behind = [&](std::string_view key) {
        const auto at = head.find(key);
        require(at != head.npos, name, ": the head ", detail::quoted(head), " has no ", key, ".");
        return head.substr(at + key.size());
    };
    std::string_view type = behind("'descr':");
    type.remove_prefix(std::min(type.find('\'') + 1, type.size()));
    type = type.substr(0, type.find('\''));
    constexpr std::array<std::pair<std::string_view, SampleType>, 9> types{{{"u1", SampleType::uint8},
                                                                            {"i1", SampleType::int8},
                                                                            {"b1", SampleType::uint8},
                                                                            {"u2", SampleType::uint16},
                                                                            {"i2", SampleType::int16},
                                                                            {"u4", SampleType::uint32},
                                                                            {"i4", SampleType::int32},
                                                                            {"f4", SampleType::float32},
                                                                            {"f8", SampleType::float64}}};
    const auto known = std::find_if(types.begin(), types.end(),
                                    [&](const auto& t) { return !type.empty() && type.substr(1) == t.first; });
    require(known != types.end(), name, ": the array is of type ", detail::quoted(type),
            "; whole numbers of 1, 2 or 4 bytes and floating-point numbers of 4 or 8 are read.");
    std::string_view order = behind("'fortran_order':");
    const bool fortran = order.substr(0, order.find(',')).find("True") != order.npos;
    std::string shape(behind("'shape':"));
    shape = shape.substr(0, shape.find(')'));
    std::replace_if(
        shape.begin(), shape.end(), [](char c) { return c == '(' || c == ','; }, ' ');
    auto size = detail::size_in(name, shape);
    if (!fortran) // the last index runs fastest
        std::swap(size[0], size[2]);
    const GreyImage image =
        detail::image_of(name, bytes, head_at + head_size, size, known->second, type.front() != '>');
    return fastest == Fastest::z ? detail::turned_round(image) : image;
}

/// A NRRD file with its data in it, encoding raw. @param bytes the whole file @param name of the file, for messages
/// @throws Error where it is no such file
[[nodiscard]] inline GreyImage parse_nrrd(std::string_view bytes, std::string_view name = "NRRD file") {
    require(bytes.substr(0, 4) == "NRRD", name, ": the file does not begin with NRRD.");
    std::string_view rest = bytes;
    std::optional<SampleType> type;
    std::optional<std::array<long long, 3>> size;
    bool little = true, raw = false;
    Point<3> sides = Point<3>::Zero();
    for (;;) {
        require(!rest.empty(), name, ": the head has no end (an empty line).");
        const std::string_view line = detail::next_line(rest);
        if (line.empty())
            break;
        const auto parts = line.front() == '#' ? std::nullopt : detail::split_at(line, ":");
        if (!parts)
            continue;
        const std::string_view key = parts->first, value = parts->second;
        if (key == "type") {
            constexpr std::array<std::pair<std::string_view, SampleType>, 22> types{
                {{"uchar", SampleType::uint8},
                 {"unsigned char", SampleType::uint8},
                 {"uint8", SampleType::uint8},
                 {"uint8_t", SampleType::uint8},
                 {"signed char", SampleType::int8},
                 {"int8", SampleType::int8},
                 {"int8_t", SampleType::int8},
                 {"ushort", SampleType::uint16},
                 {"unsigned short", SampleType::uint16},
                 {"uint16", SampleType::uint16},
                 {"uint16_t", SampleType::uint16},
                 {"short", SampleType::int16},
                 {"int16", SampleType::int16},
                 {"int16_t", SampleType::int16},
                 {"uint", SampleType::uint32},
                 {"unsigned int", SampleType::uint32},
                 {"uint32", SampleType::uint32},
                 {"uint32_t", SampleType::uint32},
                 {"int", SampleType::int32},
                 {"int32", SampleType::int32},
                 {"float", SampleType::float32},
                 {"double", SampleType::float64}}};
            const auto known =
                std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == value; });
            require(known != types.end(), name, ": the type is ", detail::quoted(value), ", which is not read.");
            type = known->second;
        } else if (key == "sizes") {
            size = detail::size_in(name, value);
        } else if (key == "endian") {
            little = value == "little";
        } else if (key == "encoding") {
            raw = value == "raw";
            require(raw, name, ": the encoding is ", detail::quoted(value),
                    "; raw is read. Read gzip with read_compressed_image(), or convert the file (unu save -f nrrd -e "
                    "raw).");
        } else if (key == "spacings") {
            const auto numbers = detail::numbers_in(value);
            for (std::size_t k = 0; k < 3 && numbers.size() == 3; ++k)
                sides[static_cast<int>(k)] = numbers[k];
        } else {
            require(key != "data file" && key != "datafile", name,
                    ": the voxels are in another file. Convert it to one file (.nrrd).");
        }
    }
    require(type && size && raw, name, ": the head must say type, sizes and encoding.");
    GreyImage image = detail::image_of(name, bytes, bytes.size() - rest.size(), *size, *type, little);
    image.sides = sides;
    return image;
}

/// The header of a MetaImage.
struct MetaImageHead {
    std::array<long long, 3> size{};     ///< voxels along x, y, z
    SampleType type = SampleType::uint8; ///< of a voxel
    bool little = true;                  ///< whether the lowest byte of a number comes first
    Point<3> sides{0, 0, 0};             ///< of a voxel, in the file's unit
    long long skip = 0;                  ///< bytes before the voxels in their file; -1: all bytes that are not voxels
    std::string file;                    ///< the file with the voxels; "LOCAL": behind the header
    std::size_t length = 0;              ///< of the header, bytes
};

/// The head of a MetaImage (.mhd, or the beginning of a .mha). @param bytes the file @param name of it, for messages
/// @throws Error where it is no such head, or the voxels are compressed
[[nodiscard]] inline MetaImageHead parse_meta_image_head(std::string_view bytes, std::string_view name = "MHD file") {
    MetaImageHead head;
    std::string_view rest = bytes;
    bool has_type = false;
    while (head.file.empty()) {
        require(!rest.empty(), name, ": the head does not say where the voxels are (ElementDataFile).");
        const auto parts = detail::split_at(detail::next_line(rest), "=");
        if (!parts)
            continue;
        const std::string_view key = parts->first, value = parts->second;
        const bool yes = detail::lower_case(value) == "true";
        if (key == "NDims")
            require(value == "3", name, ": the image has ", detail::quoted(value), " dimensions; it must have 3.");
        else if (key == "DimSize")
            head.size = detail::size_in(name, value);
        else if (key == "ElementSpacing") {
            const auto numbers = detail::numbers_in(value);
            for (std::size_t k = 0; k < 3 && numbers.size() == 3; ++k)
                head.sides[static_cast<int>(k)] = numbers[k];
        } else if (key == "ElementByteOrderMSB" || key == "BinaryDataByteOrderMSB")
            head.little = !yes;
        else if (key == "CompressedData")
            require(
                !yes, name,
                ": the voxels are compressed. Read it with read_compressed_image(), or save it without compression.");
        else if (key == "HeaderSize") {
            const auto skip = detail::whole_number_of(value);
            require(skip && *skip >= -1, name, ": HeaderSize is ", detail::quoted(value), "; it must be -1 or more.");
            head.skip = *skip;
        } else if (key == "ElementNumberOfChannels")
            require(value == "1", name, ": a voxel has ", detail::quoted(value), " numbers; it must have 1.");
        else if (key == "ElementType") {
            constexpr std::array<std::pair<std::string_view, SampleType>, 8> types{
                {{"MET_UCHAR", SampleType::uint8},
                 {"MET_CHAR", SampleType::int8},
                 {"MET_USHORT", SampleType::uint16},
                 {"MET_SHORT", SampleType::int16},
                 {"MET_UINT", SampleType::uint32},
                 {"MET_INT", SampleType::int32},
                 {"MET_FLOAT", SampleType::float32},
                 {"MET_DOUBLE", SampleType::float64}}};
            const auto known =
                std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == value; });
            require(known != types.end(), name, ": the type is ", detail::quoted(value), ", which is not read.");
            head.type = known->second;
            has_type = true;
        } else if (key == "ElementDataFile")
            head.file = value;
    }
    require(head.size[0] > 0 && has_type, name, ": the head must say DimSize and ElementType.");
    require(head.file.find_first_of("% ") == std::string::npos, name,
            ": the voxels are in several files. Save the image in one.");
    head.length = bytes.size() - rest.size();
    return head;
}

/// A MetaImage. @param head what parse_meta_image_head() found @param bytes of the file that has the voxels
/// @param name of it, for messages @throws Error where the file is too short
[[nodiscard]] inline GreyImage parse_meta_image(const MetaImageHead& head, std::string_view bytes,
                                                std::string_view name = "MHD file") {
    const std::size_t needed = detail::voxels_of(name, head.size) * detail::bytes_of(head.type);
    const std::size_t skip = head.file == "LOCAL" ? head.length
                             : head.skip < 0 && bytes.size() >= needed
                                 ? bytes.size() - needed
                                 : static_cast<std::size_t>(std::max(head.skip, 0LL));
    GreyImage image = detail::image_of(name, bytes, skip, head.size, head.type, head.little);
    image.sides = head.sides;
    return image;
}

/// A NIfTI-1 file (.nii) of one volume. @param bytes the whole file @param name of the file, for messages
/// @throws Error where it is no such file
[[nodiscard]] inline GreyImage parse_nifti(std::string_view bytes, std::string_view name = "NIfTI file") {
    require(bytes.size() >= 352, name, ": the file is ", bytes.size(), " bytes long; the head alone has 352.");
    require(bytes.substr(0, 2) != "\x1f\x8b", name,
            ": the file is compressed (gzip). Read it with read_compressed_image(), or unpack it: gunzip.");
    const bool little = detail::number_at<std::int32_t>(bytes, 0, true) == 348;
    require(little || detail::number_at<std::int32_t>(bytes, 0, false) == 348, name,
            ": the file does not begin with 348, as NIfTI-1 does.");
    require(bytes.substr(344, 3) == "n+1", name,
            ": the voxels are in another file (.img). Save the image as one .nii.");
    const auto short_at = [&](std::size_t at) { return detail::number_at<std::int16_t>(bytes, at, little); };
    const auto float_at = [&](std::size_t at) {
        return static_cast<double>(detail::number_at<float>(bytes, at, little));
    };
    const int dimensions = short_at(40);
    require(dimensions >= 3 && dimensions <= 7, name, ": the image has ", dimensions, " dimensions; it must have 3.");
    std::array<long long, 3> size;
    Point<3> sides;
    for (std::size_t k = 0; k < 3; ++k) {
        size[k] = short_at(42 + 2 * k);
        sides[static_cast<int>(k)] = float_at(80 + 4 * k);
    }
    for (int k = 3; k < dimensions; ++k)
        require(short_at(42 + 2 * static_cast<std::size_t>(k)) <= 1, name,
                ": there is more than one volume in the file.");
    constexpr std::array<std::pair<int, SampleType>, 8> types{{{2, SampleType::uint8},
                                                               {256, SampleType::int8},
                                                               {512, SampleType::uint16},
                                                               {4, SampleType::int16},
                                                               {768, SampleType::uint32},
                                                               {8, SampleType::int32},
                                                               {16, SampleType::float32},
                                                               {64, SampleType::float64}}};
    const int code = short_at(70);
    const auto known = std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == code; });
    require(known != types.end(), name, ": the voxels are of type ", code, ", which is not read.");
    const double offset = float_at(108);
    require(offset >= 348 && offset <= static_cast<double>(bytes.size()), name,
            ": the voxels are said to begin at byte ", offset, " of ", bytes.size(), ".");
    GreyImage image = detail::image_of(name, bytes, static_cast<std::size_t>(offset), size, known->second, little);
    if (sides.allFinite() && sides.minCoeff() > 0)
        image.sides = sides;
    if (const auto slope = static_cast<float>(float_at(112)); slope != 0)
        for (float& value : image.values)
            value = slope * value + static_cast<float>(float_at(116));
    return image;
}

/// A TIFF file, uncompressed, of one page a slice and one number a voxel, of 1, 8, 16 or 32 bits. Rows run along x, one
/// below the other along y, pages along z. @param bytes the whole file @param name of the file, for messages
/// @throws Error where it is no such file
[[nodiscard]] inline GreyImage parse_tiff(std::string_view bytes, std::string_view name = "TIFF file") {
    require(bytes.size() >= 8 && (bytes.substr(0, 2) == "II" || bytes.substr(0, 2) == "MM"), name,
            ": the file does not begin as TIFF does.");
    const bool little = bytes[0] == 'I';
    const auto short_at = [&](std::size_t at) {
        require(at + 2 <= bytes.size(), name, ": the file ends before all of it is there. It is cut off.");
        return detail::number_at<std::uint16_t>(bytes, at, little);
    };
    const auto long_at = [&](std::size_t at) {
        require(at + 4 <= bytes.size(), name, ": the file ends before all of it is there. It is cut off.");
        return detail::number_at<std::uint32_t>(bytes, at, little);
    };
    require(short_at(2) == 42, name, ": the file is ", short_at(2) == 43 ? "a BigTIFF" : "of another kind",
            "; plain TIFF is read here, every TIFF with read_tiff().");
    GreyImage image;
    for (std::size_t page = long_at(4); page != 0;) {
        std::uint32_t width = 0, height = 0, bits = 1, compression = 1, white_is_zero = 0, per_pixel = 1, format = 1;
        std::uint32_t rows_per_strip = 0xffffffffu;
        std::vector<std::uint32_t> strips;
        const std::size_t entries = short_at(page);
        for (std::size_t k = 0; k < entries; ++k) {
            const std::size_t entry = page + 2 + 12 * k;
            const auto tag = short_at(entry), type = short_at(entry + 2);
            const std::uint32_t number = long_at(entry + 4);
            const auto value = [&](std::uint32_t which) -> std::uint32_t { // of whole numbers
                const std::size_t each = type == 3 ? 2 : 4;
                const std::size_t from = number * each <= 4 ? entry + 8 : long_at(entry + 8);
                return type == 3 ? short_at(from + each * which) : long_at(from + each * which);
            };
            require(tag != 322, name,
                    ": the pages are in tiles; strips are read. Read it with read_tiff(), or save it without tiles.");
            if (tag == 256)
                width = value(0);
            else if (tag == 257)
                height = value(0);
            else if (tag == 258)
                bits = value(0);
            else if (tag == 259)
                compression = value(0);
            else if (tag == 262)
                white_is_zero = value(0) == 0;
            else if (tag == 277)
                per_pixel = value(0);
            else if (tag == 278)
                rows_per_strip = value(0);
            else if (tag == 339)
                format = value(0);
            else if (tag == 273) {
                require(number <= bytes.size(), name, ": a page is said to be in ", number, " strips.");
                for (std::uint32_t strip = 0; strip < number; ++strip)
                    strips.push_back(value(strip));
            }
        }
        require(compression == 1, name, ": the pages are compressed (kind ", compression,
                "). Read it with read_tiff(), or save the image without compression.");
        require(per_pixel == 1, name, ": a voxel has ", per_pixel, " numbers (colours); it must have 1.");
        std::optional<SampleType> type;
        if (bits == 8 || bits == 1)
            type = format == 2 ? SampleType::int8 : SampleType::uint8;
        else if (bits == 16 && format != 3)
            type = format == 2 ? SampleType::int16 : SampleType::uint16;
        else if (bits == 32)
            type = format == 3 ? SampleType::float32 : format == 2 ? SampleType::int32 : SampleType::uint32;
        require(type.has_value(), name, ": a voxel has ", bits, " bits of format ", format, ", which is not read.");
        if (image.size[2] == 0) {
            require(width >= 1 && height >= 1 && width <= 1000000 && height <= 1000000, name, ": a page is ", width,
                    " x ", height, " voxels.");
            image.size = {static_cast<int>(width), static_cast<int>(height), 0};
        }
        require(static_cast<int>(width) == image.size[0] && static_cast<int>(height) == image.size[1], name, ": page ",
                image.size[2], " is ", width, " x ", height, " voxels, the first ", image.size[0], " x ", image.size[1],
                ".");
        require(rows_per_strip >= 1 && !strips.empty(), name, ": page ", image.size[2], " has no voxels.");
        const std::size_t row_bytes = bits == 1 ? (width + 7) / 8 : std::size_t{width} * (bits / 8);
        require(row_bytes * height <= bytes.size() / static_cast<std::size_t>(image.size[2] + 1), name,
                ": the file is ", bytes.size(), " bytes long, less than ", image.size[2] + 1, " pages of ", width,
                " x ", height, " voxels are. It is cut off.");
        for (std::uint32_t y = 0; y < height; ++y) {
            const std::size_t strip = y / rows_per_strip;
            require(strip < strips.size(), name, ": page ", image.size[2], " has ", strips.size(), " strips of ",
                    rows_per_strip, " rows, too few for ", height, " rows.");
            const std::size_t row = strips[strip] + row_bytes * (y % rows_per_strip);
            require(row + row_bytes <= bytes.size(), name, ": the file ends before all of it is there. It is cut off.");
            for (std::size_t x = 0; x < width; ++x) {
                float value = 0;
                if (bits == 1)
                    value = static_cast<float>(static_cast<unsigned char>(bytes[row + x / 8]) >> (7 - x % 8) & 1);
                else
                    value = detail::sample_at(bytes, row + x * (bits / 8), *type, little);
                if (white_is_zero && format == 1)
                    value = static_cast<float>((bits == 32 ? 4294967295.0 : (1u << bits) - 1)) - value;
                image.values.push_back(value);
            }
        }
        ++image.size[2];
        page = long_at(page + 2 + 12 * entries);
    }
    require(image.size[2] >= 1, name, ": the file has no page.");
    return image;
}

/// A VTK image (.vti) whose first array of one number a voxel is appended in raw form. @param bytes the whole file
/// @param name of the file, for messages @throws Error where it is no such file
[[nodiscard]] inline GreyImage parse_vti(std::string_view bytes, std::string_view name = "VTI file") {
    const auto tag_from = [&](std::string_view what, std::size_t from) {
        const auto at = bytes.find(what, from);
        require(at != bytes.npos, name, ": the file has no ", what, " ...>.");
        return std::pair{bytes.substr(at, bytes.find('>', at) - at), at};
    };
    const auto attribute = [](std::string_view tag, std::string_view key) {
        const std::string begin = " " + std::string(key) + "=\"";
        const auto at = tag.find(begin);
        if (at == tag.npos)
            return std::string_view();
        const std::string_view value = tag.substr(at + begin.size());
        return value.substr(0, value.find('"'));
    };
    const auto [file, file_at] = tag_from("<VTKFile", 0);
    require(attribute(file, "type") == "ImageData", name, ": the file holds ", detail::quoted(attribute(file, "type")),
            "; it must hold ImageData.");
    require(attribute(file, "compressor").empty(), name,
            ": the voxels are compressed. Read it with read_compressed_image(), or save it without compression.");
    const bool little = attribute(file, "byte_order") != "BigEndian", wide = attribute(file, "header_type") == "UInt64";
    const auto [head, head_at] = tag_from("<ImageData", file_at);
    const auto extent = detail::numbers_in(attribute(head, "WholeExtent"));
    require(extent.size() == 6, name, ": WholeExtent is ", detail::quoted(attribute(head, "WholeExtent")),
            "; it must be six whole numbers.");
    const auto found = tag_from("<DataArray", head_at);
    const std::string_view array = found.first;
    const std::size_t array_at = found.second;
    const auto points_at = bytes.find("<PointData", head_at);
    const auto cells_at = bytes.find("<CellData", head_at);
    const bool of_points = points_at < array_at && !(cells_at < array_at && cells_at > points_at);
    std::array<long long, 3> size;
    for (std::size_t k = 0; k < 3; ++k) {
        const double length = extent[2 * k + 1] - extent[2 * k] + (of_points ? 1 : 0);
        require(length >= 1 && length <= 1e6, name, ": the image is ", length,
                " voxels long along one axis; from 1 to 1000000 are allowed.");
        size[k] = static_cast<long long>(length);
    }
    constexpr std::array<std::pair<std::string_view, SampleType>, 8> types{{{"UInt8", SampleType::uint8},
                                                                            {"Int8", SampleType::int8},
                                                                            {"UInt16", SampleType::uint16},
                                                                            {"Int16", SampleType::int16},
                                                                            {"UInt32", SampleType::uint32},
                                                                            {"Int32", SampleType::int32},
                                                                            {"Float32", SampleType::float32},
                                                                            {"Float64", SampleType::float64}}};
    const auto known =
        std::find_if(types.begin(), types.end(), [&](const auto& t) { return t.first == attribute(array, "type"); });
    require(known != types.end(), name, ": the voxels are of type ", detail::quoted(attribute(array, "type")),
            ", which is not read.");
    const std::string_view components = attribute(array, "NumberOfComponents");
    require(components.empty() || components == "1", name, ": a voxel has ", detail::quoted(components),
            " numbers; it must have 1.");
    require(attribute(array, "format") == "appended", name, ": the voxels are ",
            detail::quoted(attribute(array, "format")), "; appended, raw ones are read.");
    const auto [appended, appended_at] = tag_from("<AppendedData", array_at);
    require(attribute(appended, "encoding") == "raw", name, ": the voxels are encoded as ",
            detail::quoted(attribute(appended, "encoding")), "; raw ones are read.");
    const auto mark = bytes.find('_', appended_at + appended.size());
    const auto offset = detail::whole_number_of(attribute(array, "offset"));
    require(mark != bytes.npos && offset && *offset >= 0 && *offset < 1000000000000LL, name,
            ": it is not said where the voxels begin.");
    GreyImage image = detail::image_of(name, bytes, mark + 1 + static_cast<std::size_t>(*offset) + (wide ? 8 : 4), size,
                                       known->second, little);
    const auto sides = detail::numbers_in(attribute(head, "Spacing"));
    for (std::size_t k = 0; k < 3 && sides.size() == 3; ++k)
        image.sides[static_cast<int>(k)] = sides[k];
    return image;
}

/// The grey values in a file without a header, as parse_raw() takes them.
/// @param path the file @param size voxels along x, y, z @param type of a voxel @param fastest the axis that runs
/// fastest
/// @param little whether the lowest byte of a number comes first
[[nodiscard]] inline GreyImage read_raw(const std::filesystem::path& path, const std::array<int, 3>& size,
                                        SampleType type, Fastest fastest, bool little = true) {
    return parse_raw(detail::bytes_of_file("read_raw", path), size, type, fastest, little, path.string());
}

/// The grey values in a numpy file, as parse_npy() takes them. @param path the file @param fastest the axis that runs
/// fastest
[[nodiscard]] inline GreyImage read_npy(const std::filesystem::path& path, Fastest fastest) {
    return parse_npy(detail::bytes_of_file("read_npy", path), fastest, path.string());
}

/// The grey values in a file of the type given by its ending, .nrrd, .mhd, .mha, .nii, .tif, .tiff or .vti. Files
/// without a size or a fastest axis are read with read_raw() and read_npy().
/// @param path the file
/// @throws Error if the file cannot be read, is compressed, damaged or of another kind
[[nodiscard]] inline GreyImage read_image(const std::filesystem::path& path) {
    const std::string kind = detail::lower_case(path.extension().string()), name = path.string();
    constexpr std::array<std::string_view, 7> kinds{".nrrd", ".mhd", ".mha", ".nii", ".tif", ".tiff", ".vti"};
    require(
        std::find(kinds.begin(), kinds.end(), kind) != kinds.end(), "read_image: ", name, " ends with \"", kind,
        "\"; images are read from .nrrd, .mhd, .mha, .nii, .tif and .vti, by read_raw() from files without a head, ",
        "and by read_npy() from .npy.");
    const std::string bytes = detail::bytes_of_file("read_image", path);
    if (kind == ".nrrd")
        return parse_nrrd(bytes, name);
    if (kind == ".nii")
        return parse_nifti(bytes, name);
    if (kind == ".vti")
        return parse_vti(bytes, name);
    if (kind != ".mhd" && kind != ".mha")
        return parse_tiff(bytes, name);
    const MetaImageHead head = parse_meta_image_head(bytes, name);
    if (head.file == "LOCAL")
        return parse_meta_image(head, bytes, name);
    const std::filesystem::path beside = path.parent_path() / head.file;
    return parse_meta_image(head, detail::bytes_of_file("read_image", beside), beside.string());
}

} // namespace imbibe
