// Particles as VTK files: one `.vtp` file a snapshot, which ParaView, VisIt and VTK open. vtk_series.hpp lists them by
// time.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/core/field.hpp>
#include <imbibe/output/file.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace imbibe {

/// How many digits of a double a VTK file keeps: all, or those of a float in half the space.
enum class VtkPrecision { as_given, single };

/// One quantity per particle, as the caller stores it: component c of particle i is `data[c * stride + i]` (structure
/// of arrays). It is a view; the data must live until the file has been written.
///
/// `columns` selects the output: its k-th component is the stored component `columns[k]`, or zero if that is -1.
struct VtkArray {
    /// A name for the menus of ParaView; unique in a file.
    std::string name;
    /// The SI unit; stored in the file. May be empty.
    std::string unit;
    /// Where the numbers are.
    std::variant<const float*, const double*, const std::int32_t*, const std::int64_t*> data;
    /// How many numbers lie between two components of a particle.
    std::size_t stride = 0;
    /// Which stored component each written one is; -1: zero.
    std::vector<int> columns = {0};

    /// A view of a field of this rank in `dim` = 2 or 3 dimensions, in the order of core/vector.hpp: vectors x, y, z;
    /// symmetric tensors xx, xy, xz, yy, yz, zz; tensors row by row. Components missing in 2D are written as zero, and
    /// symmetric tensors are written in VTK's own order xx, yy, zz, xy, yz, xz. Throws Error for another `dim`.
    template <class T>
    static VtkArray of(std::string name, std::string unit, Rank rank, int dim, const T* data, std::size_t stride) {
        require(dim == 2 || dim == 3, "VTK array ", name, ": dim = ", dim, "; it must be 2 or 3");
        return {std::move(name), std::move(unit), data, stride, columns_of(rank, dim)};
    }
    /// A view of one number per particle.
    template <class T>
    static VtkArray scalar(std::string name, std::string unit, const T* data) {
        return {std::move(name), std::move(unit), data, 0, {0}};
    }
    /// A view of a vector per particle, in `dim` = 2 or 3 dimensions.
    template <class T>
    static VtkArray vector(std::string name, std::string unit, int dim, const T* data, std::size_t stride) {
        return of(std::move(name), std::move(unit), Rank::vector, dim, data, stride);
    }

private:
    static std::vector<int> columns_of(Rank rank, int dim);
};

namespace detail {

/// The shortest decimal number that reads back as the same double.
inline std::string shortest(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

/// `words` with XML's special characters escaped.
inline std::string xml_escaped(std::string_view words) {
    std::string safe;
    for (const char c : words) {
        switch (c) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += c;
        }
    }
    return safe;
}

template <class T>
inline constexpr std::string_view vtk_type = "Float64";
template <>
inline constexpr std::string_view vtk_type<float> = "Float32";
template <>
inline constexpr std::string_view vtk_type<std::int32_t> = "Int32";
template <>
inline constexpr std::string_view vtk_type<std::int64_t> = "Int64";

inline std::string_view byte_order() {
    return std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
}

} // namespace detail

/// One snapshot of one set of particles. Arrays are added as views; write() puts them into a file without a copy of the
/// whole.
/// <!-- tests/output/test_vtk.cpp -->
/// ```
/// const VtkFile file(n, VtkArray::vector("position", "m", 3, x.data(), n));
/// file.write(folder / "double.vtp");
/// file.write(folder / "single.vtp", VtkPrecision::single);
/// ```
class VtkFile {
public:
    /// `position` has 2 or 3 components, m; 2D points are written with z = 0. Throws Error for anything else.
    VtkFile(std::size_t particles, VtkArray where);

    /// Adds a quantity. Throws Error if its name is empty or taken, or if data are missing.
    VtkFile& add(VtkArray array);
    /// One number for the whole file, such as the particle spacing in m (tools/render_sponge.py looks for "spacing").
    VtkFile& constant(std::string name, double value) {
        constants_.emplace_back(std::move(name), value);
        return *this;
    }
    /// The time of the snapshot, s, which ParaView shows.
    VtkFile& time(double seconds) { return constant("TimeValue", seconds); }

    /// Writes the file completely or not at all (see AtomicFile). Throws Error when it cannot be written.
    void write(const std::filesystem::path& path, VtkPrecision precision = VtkPrecision::as_given) const;

private:
    /// Calls use(pointer, as) with the stored pointer and a value of the type to be written.
    template <class Use>
    static void visit(const VtkArray& array, VtkPrecision precision, Use use) {
        std::visit(
            [&]<class T>(const T* data) {
                if constexpr (std::is_same_v<T, double>)
                    if (precision == VtkPrecision::single)
                        return use(data, float{});
                use(data, T{});
            },
            array.data);
    }

    void check(const VtkArray& array) const;

    /// The opening of one DataArray element, without its end; moves `offset` past its data.
    std::string header(std::string_view type, std::string_view name, std::size_t components, std::size_t bytes,
                       std::uint64_t& offset) const;
    std::string described(const VtkArray& array, VtkPrecision precision, std::uint64_t& offset) const;

    /// Transposes in small blocks: VTK stores particle by particle, the library component by component.
    void put(AtomicFile& file, const VtkArray& array, VtkPrecision precision) const;
    void put_counting(AtomicFile& file, std::int32_t from) const;
    static void put_size(AtomicFile& file, std::uint64_t bytes) { file.write(&bytes, sizeof bytes); }

    static constexpr std::size_t block_size = 4096;
    std::size_t particles_;
    VtkArray position_;
    std::vector<VtkArray> arrays_;
    std::vector<std::pair<std::string, double>> constants_;
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/output/vtk_code.hpp>
#endif
