// The code of vtk.hpp: writes particles as VTK files.
#pragma once

#include <imbibe/output/vtk.hpp>

namespace imbibe {

IMBIBE_CODE std::vector<int> VtkArray::columns_of(Rank rank, int dim) {
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

IMBIBE_CODE VtkFile::VtkFile(std::size_t particles, VtkArray where)
    : particles_(particles), position_(std::move(where)) {
    require(position_.columns.size() == 3, "VTK file: position has ", position_.columns.size(),
            " components; make it with VtkArray::vector(name, unit, dim, data, stride)");
    require(!std::holds_alternative<const std::int32_t*>(position_.data) &&
                !std::holds_alternative<const std::int64_t*>(position_.data),
            "VTK file: position holds whole numbers; it must be float or double");
    check(position_);
}

IMBIBE_CODE VtkFile& VtkFile::add(VtkArray array) {
    require(!array.name.empty(), "VTK file: an array has no name");
    require(std::none_of(arrays_.begin(), arrays_.end(), [&](const auto& a) { return a.name == array.name; }),
            "VTK file: there are two arrays called ", array.name, "; give one of them another name");
    check(array);
    arrays_.push_back(std::move(array));
    return *this;
}

IMBIBE_CODE void VtkFile::write(const std::filesystem::path& path, VtkPrecision precision) const {
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

IMBIBE_CODE void VtkFile::check(const VtkArray& array) const {
    const auto components = array.columns.size();
    require(components == 1 || components == 3 || components == 6 || components == 9, "VTK array ", array.name, " has ",
            components, " components; 1, 3 (vector), 6 (symmetric tensor) or 9 (tensor) can be written");
    require(*std::max_element(array.columns.begin(), array.columns.end()) < 1 || array.stride >= particles_,
            "VTK array ", array.name, ": its stride of ", array.stride, " is less than the ", particles_,
            " particles, so its components would overlap");
    visit(array, VtkPrecision::as_given, [&](const auto* data, auto) {
        require(particles_ == 0 || data != nullptr, "VTK array ", array.name, " has no data");
    });
    require(particles_ < (std::size_t{1} << 31), "VTK file: ", particles_,
            " particles; a file holds less than 2^31: write them in parts");
}

IMBIBE_CODE std::string VtkFile::header(std::string_view type, std::string_view name, std::size_t components,
                                        std::size_t bytes, std::uint64_t& offset) const {
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

IMBIBE_CODE std::string VtkFile::described(const VtkArray& array, VtkPrecision precision, std::uint64_t& offset) const {
    std::string xml;
    visit(array, precision, [&]<class As>(const auto*, As) {
        xml = header(detail::vtk_type<As>, array.name, array.columns.size(), sizeof(As), offset);
    });
    if (array.unit.empty())
        return xml + "/>\n";
    return xml + ">\n<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">" +
           detail::xml_escaped(array.unit) + "</InformationKey>\n</DataArray>\n";
}

IMBIBE_CODE void VtkFile::put(AtomicFile& file, const VtkArray& array, VtkPrecision precision) const {
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

IMBIBE_CODE void VtkFile::put_counting(AtomicFile& file, std::int32_t from) const {
    put_size(file, particles_ * sizeof(std::int32_t));
    std::vector<std::int32_t> block(std::min(particles_, block_size));
    for (std::size_t first = 0; first < particles_; first += block_size) {
        const auto count = std::min(block_size, particles_ - first);
        for (std::size_t i = 0; i < count; ++i)
            block[i] = static_cast<std::int32_t>(first + i) + from;
        file.write(block.data(), count * sizeof(std::int32_t));
    }
}

} // namespace imbibe
