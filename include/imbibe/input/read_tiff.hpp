// Reads TIFF images of every compression, in tiles and as BigTIFF, with libtiff, which a program that includes this
// links (-ltiff; find_package(TIFF), TIFF::TIFF).
#pragma once

#include <imbibe/input/read_image.hpp>

#include <tiffio.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace imbibe {

namespace detail {

/// Keeps libtiff from printing while it lives; its destructor restores the program's handlers.
class QuietTiff {
public:
    QuietTiff() = default;
    ~QuietTiff() {
        TIFFSetErrorHandler(errors_);
        TIFFSetWarningHandler(warnings_);
    }
    QuietTiff(const QuietTiff&) = delete;
    QuietTiff& operator=(const QuietTiff&) = delete;

private:
    TIFFErrorHandler errors_ = TIFFSetErrorHandler(nullptr), warnings_ = TIFFSetWarningHandler(nullptr);
};

} // namespace detail

/// The grey values of a TIFF file of one page a slice and one number a voxel, of 1, 8, 16 or 32 bits. Rows run along x,
/// one below the other along y, pages along z. @param path the file
/// @throws Error where the file cannot be read, is damaged or of another kind
[[nodiscard]] inline GreyImage read_tiff(const std::filesystem::path& path) {
    const std::string name = path.string();
    const detail::QuietTiff quiet; // what goes wrong is said below
    const std::unique_ptr<TIFF, void (*)(TIFF*)> file(TIFFOpen(name.c_str(), "r"), TIFFClose);
    require(file != nullptr, "read_tiff: ", name, " cannot be opened, or is no TIFF file.");
    TIFF* const tiff = file.get();
    GreyImage image;
    do {
        std::uint32_t width = 0, height = 0, tile_width = 0, tile_height = 0;
        std::uint16_t bits = 1, per_pixel = 1, format = SAMPLEFORMAT_UINT, light = PHOTOMETRIC_MINISBLACK;
        TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
        TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &height);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &per_pixel);
        TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format);
        TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &light);
        require(per_pixel == 1, name, ": a voxel has ", per_pixel, " numbers (colours); it must have 1.");
        require(width >= 1 && height >= 1 && width <= 1000000 && height <= 1000000, name, ": a page is ", width, " x ",
                height, " voxels.");
        if (image.size[2] == 0)
            image.size = {static_cast<int>(width), static_cast<int>(height), 0};
        require(static_cast<int>(width) == image.size[0] && static_cast<int>(height) == image.size[1], name, ": page ",
                image.size[2], " is ", width, " x ", height, " voxels, the first ", image.size[0], " x ", image.size[1],
                ".");
        detail::voxels_of(name, {image.size[0], image.size[1], image.size[2] + 1});
        const bool whole = format != SAMPLEFORMAT_IEEEFP, with_sign = format == SAMPLEFORMAT_INT;
        std::optional<SampleType> type;
        if (bits == 1 || (bits == 8 && whole))
            type = with_sign ? SampleType::int8 : SampleType::uint8;
        else if (bits == 16 && whole)
            type = with_sign ? SampleType::int16 : SampleType::uint16;
        else if (bits == 32)
            type = !whole ? SampleType::float32 : with_sign ? SampleType::int32 : SampleType::uint32;
        require(type.has_value(), name, ": a voxel has ", bits, " bits of format ", format, ", which is not read.");

        const bool tiled = TIFFIsTiled(tiff) != 0;
        if (tiled) {
            TIFFGetField(tiff, TIFFTAG_TILEWIDTH, &tile_width);
            TIFFGetField(tiff, TIFFTAG_TILELENGTH, &tile_height);
        } else {
            TIFFGetFieldDefaulted(tiff, TIFFTAG_ROWSPERSTRIP, &tile_height);
            tile_width = width;
            tile_height = std::min(tile_height, height);
        }
        const auto size = static_cast<std::uint64_t>(tiled ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff));
        const std::size_t row_bytes =
            bits == 1 ? (std::size_t{tile_width} + 7) / 8 : std::size_t{tile_width} * bits / 8;
        require(tile_width >= 1 && tile_height >= 1 && size >= row_bytes * tile_height && size <= 2000000000, name,
                ": a strip or tile of page ", image.size[2], " is ", tile_width, " x ", tile_height, " voxels and ",
                size, " bytes.");
        std::string block(static_cast<std::size_t>(size), '\0');
        const std::size_t page = image.values.size();
        image.values.resize(page + std::size_t{width} * height);
        const std::uint32_t across = (width + tile_width - 1) / tile_width;
        const std::uint32_t number = tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
        for (std::uint32_t k = 0; k < number; ++k) {
            const auto room = static_cast<tmsize_t>(block.size());
            const tmsize_t got = tiled ? TIFFReadEncodedTile(tiff, k, block.data(), room)
                                       : TIFFReadEncodedStrip(tiff, k, block.data(), room);
            const std::uint64_t left = std::uint64_t{k % across} * tile_width,
                                top = std::uint64_t{k / across} * tile_height;
            if (top >= height)
                break;
            const std::size_t rows = std::min<std::size_t>(tile_height, height - top);
            require(
                got >= static_cast<tmsize_t>(row_bytes * rows), name, ": page ", image.size[2],
                " cannot be unpacked. It is damaged or cut off, or packed in a way that this libtiff does not know.");
            for (std::size_t y = 0; y < rows; ++y)
                for (std::size_t x = 0; x < tile_width && left + x < width; ++x) {
                    const std::size_t from = y * row_bytes;
                    float value = 0;
                    if (bits == 1)
                        value = static_cast<float>(static_cast<unsigned char>(block[from + x / 8]) >> (7 - x % 8) & 1);
                    else // libtiff gives numbers in the order of this machine
                        value = detail::sample_at(block, from + x * (bits / 8), *type,
                                                  std::endian::native == std::endian::little);
                    if (light == PHOTOMETRIC_MINISWHITE && whole && !with_sign)
                        value = static_cast<float>((bits == 32 ? 4294967295.0 : (1u << bits) - 1)) - value;
                    image.values[page + (top + y) * width + left + x] = value;
                }
        }
        ++image.size[2];
    } while (TIFFReadDirectory(tiff) != 0);
    return image;
}

} // namespace imbibe
