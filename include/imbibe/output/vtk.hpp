// Particles as VTK files: one `.vtp` file a snapshot, which ParaView, VisIt and VTK open. vtk_series.hpp lists them by
// time.
#pragma once

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

/// How many digits a VTK file keeps of a double: all of them, or those of a float in half the space.
enum class VtkPrecision { as_given, single };

/// One quantity per particle, as the caller stores it: component c of particle i is `data[c * stride + i]` (structure
/// of arrays). It is a view; the data must live until the file has been written.
///
/// `columns` says what VTK gets: its k-th component is the stored component `columns[k]`, or zero where that is -1.
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

    /// A view of a field of this rank in `dim` = 2 or 3 dimensions, with the order of core/vector.hpp: vectors x, y, z;
    /// symmetric tensors xx, xy, xz, yy, yz, zz; tensors row by row. What 2D lacks is written as zero, and symmetric
    /// tensors are written in VTK's own order xx, yy, zz, xy, yz, xz. Throws Error for another `dim`.
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
    static std::vector<int> columns_of(Rank rank, int dim) {
        const bool flat = dim == 2;
        switch (rank) {
        case Rank::scalar:
            return {0};
        case Rank::vector:
            return flat ? std::vector{0, 1, -1} : std::vector{0, 1, 2};
        case Rank::symmetric_tensor:
            return flat ? std::vector{0, 2, -1, 1, -1, -1} : std::vector{0, 3, 5, 1, 4, 2};
        default:
            return flat ? std::vector{0, 1, -1, 2, 3, -1, -1, -1, -1} : std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8};
        }
    }
};

namespace detail {

/// The shortest decimal number that reads back as the same double.
inline std::string shortest(double value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

/// `words` with what XML would misread replaced.
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
    VtkFile(std::size_t particles, VtkArray where) : particles_(particles), position_(std::move(where)) {
        require(position_.columns.size() == 3, "VTK file: position has ", position_.columns.size(),
                " components; make it with VtkArray::vector(name, unit, dim, data, stride)");
        require(!std::holds_alternative<const std::int32_t*>(position_.data) &&
                    !std::holds_alternative<const std::int64_t*>(position_.data),
                "VTK file: position holds whole numbers; it must be float or double");
        check(position_);
    }

    /// Adds a quantity. Throws Error if its name is empty or taken, or if it has data missing.
    VtkFile& add(VtkArray array) {
        require(!array.name.empty(), "VTK file: an array has no name");
        require(std::none_of(arrays_.begin(), arrays_.end(), [&](const auto& a) { return a.name == array.name; }),
                "VTK file: there are two arrays called ", array.name, "; give one of them another name");
        check(array);
        arrays_.push_back(std::move(array));
        return *this;
    }
    /// One number for the whole file, such as the particle spacing in m (tools/render_sponge.py looks for "spacing").
    VtkFile& constant(std::string name, double value) {
        constants_.emplace_back(std::move(name), value);
        return *this;
    }
    /// The time of the snapshot, s, which ParaView shows.
    VtkFile& time(double seconds) { return constant("TimeValue", seconds); }

    /// Writes the file as a whole or not at all (see AtomicFile). Throws Error when it cannot be written.
    void write(const std::filesystem::path& path, VtkPrecision precision = VtkPrecision::as_given) const {
        AtomicFile file(path);
        std::string xml = "<?xml version=\"1.0\"?>\n";
        xml += text("<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"", detail::byte_order(),
                    "\" header_type=\"UInt64\">\n<PolyData>\n<FieldData>\n");
        for (const auto& [name, value] : constants_)
            xml += text("<DataArray type=\"Float64\" Name=\"", detail::xml_escaped(name),
                        "\" NumberOfTuples=\"1\" format=\"ascii\">", detail::shortest(value), "</DataArray>\n");
        xml += "</FieldData>\n<Piece NumberOfPoints=\"" + std::to_string(particles_) + "\" NumberOfVerts=\"" +
               std::to_string(particles_) + "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";

        std::uint64_t offset = 0;
        xml += "<Points>\n" + described(position_, precision, offset) + "</Points>\n<PointData>\n";
        for (const auto& array : arrays_)
            xml += described(array, precision, offset);
        xml += "</PointData>\n<Verts>\n";
        for (const auto* name : {"connectivity", "offsets"})
            xml += header("Int32", name, 1, sizeof(std::int32_t), offset) + "/>\n";
        xml += "</Verts>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";

        file << xml;
        put(file, position_, precision);
        for (const auto& array : arrays_)
            put(file, array, precision);
        put_counting(file, 0); // vertex i is made of point i ...
        put_counting(file, 1); // ... and ends before entry i + 1
        file << "\n</AppendedData>\n</VTKFile>\n";
        file.commit();
    }

private:
    /// Calls use(pointer, as) with the stored pointer and a value of the type in which it is to be written.
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

    void check(const VtkArray& array) const {
        const auto components = array.columns.size();
        require(components == 1 || components == 3 || components == 6 || components == 9, "VTK array ", array.name,
                " has ", components, " components; 1, 3 (vector), 6 (symmetric tensor) or 9 (tensor) can be written");
        require(*std::max_element(array.columns.begin(), array.columns.end()) < 1 || array.stride >= particles_,
                "VTK array ", array.name, ": its stride of ", array.stride, " is less than the ", particles_,
                " particles, so its components would overlap");
        visit(array, VtkPrecision::as_given, [&](const auto* data, auto) {
            require(particles_ == 0 || data != nullptr, "VTK array ", array.name, " has no data");
        });
        require(particles_ < (std::size_t{1} << 31), "VTK file: ", particles_,
                " particles; a file holds less than 2^31: write them in parts");
    }

    /// The opening of one DataArray element, without its end; moves `offset` past its data.
    std::string header(std::string_view type, std::string_view name, std::size_t components, std::size_t bytes,
                       std::uint64_t& offset) const {
        auto xml = "<DataArray type=\"" + std::string(type) + "\" Name=\"" + detail::xml_escaped(name) +
                   "\" NumberOfComponents=\"" + std::to_string(components) + "\"";
        if (components == 6 || components == 9) {
            constexpr std::array<std::string_view, 6> symmetric{"xx", "yy", "zz", "xy", "yz", "xz"};
            constexpr std::array<std::string_view, 9> full{"xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"};
            for (std::size_t k = 0; k < components; ++k)
                xml += text(" ComponentName", k, "=\"", components == 6 ? symmetric[k] : full[k], "\"");
        }
        xml += " format=\"appended\" offset=\"" + std::to_string(offset) + "\"";
        offset += sizeof(std::uint64_t) + std::uint64_t{particles_} * components * bytes;
        return xml;
    }
    std::string described(const VtkArray& array, VtkPrecision precision, std::uint64_t& offset) const {
        std::string xml;
        visit(array, precision, [&]<class As>(const auto*, As) {
            xml = header(detail::vtk_type<As>, array.name, array.columns.size(), sizeof(As), offset);
        });
        if (array.unit.empty())
            return xml + "/>\n";
        return xml + ">\n<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">" +
               detail::xml_escaped(array.unit) + "</InformationKey>\n</DataArray>\n";
    }

    /// VTK wants particle by particle what the library keeps component by component: turned over in small blocks.
    void put(AtomicFile& file, const VtkArray& array, VtkPrecision precision) const {
        visit(array, precision, [&]<class As>(const auto* data, As) {
            const auto components = array.columns.size();
            put_size(file, particles_ * components * sizeof(As));
            std::vector<As> block(std::min(particles_, block_size) * components, As{});
            for (std::size_t first = 0; first < particles_; first += block_size) {
                const auto count = std::min(block_size, particles_ - first);
                for (std::size_t k = 0; k < components; ++k)
                    if (array.columns[k] >= 0) {
                        const auto* column = data + static_cast<std::size_t>(array.columns[k]) * array.stride + first;
                        for (std::size_t i = 0; i < count; ++i)
                            block[i * components + k] = static_cast<As>(column[i]);
                    }
                file.write(block.data(), count * components * sizeof(As));
            }
        });
    }
    void put_counting(AtomicFile& file, std::int32_t from) const {
        put_size(file, particles_ * sizeof(std::int32_t));
        std::vector<std::int32_t> block(std::min(particles_, block_size));
        for (std::size_t first = 0; first < particles_; first += block_size) {
            const auto count = std::min(block_size, particles_ - first);
            for (std::size_t i = 0; i < count; ++i)
                block[i] = static_cast<std::int32_t>(first + i) + from;
            file.write(block.data(), count * sizeof(std::int32_t));
        }
    }
    static void put_size(AtomicFile& file, std::uint64_t bytes) { file.write(&bytes, sizeof bytes); }

    static constexpr std::size_t block_size = 4096;
    std::size_t particles_;
    VtkArray position_;
    std::vector<VtkArray> arrays_;
    std::vector<std::pair<std::string, double>> constants_;
};

} // namespace imbibe
