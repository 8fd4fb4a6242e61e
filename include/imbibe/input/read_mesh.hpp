// Reads meshes of triangles from files: STL, OBJ and PLY.
#pragma once

#include <imbibe/geometry/mesh.hpp>
#include <imbibe/input/bytes.hpp>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace imbibe {

namespace detail {

/// Adds a triangle with its own corners.
inline void add_triangle(Triangles& mesh, const std::array<Point<3>, 3>& corners) {
    const auto first = static_cast<int>(mesh.corners.size());
    mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Adds a face of any number of corners as triangles round its first.
inline void add_face(Triangles& mesh, const std::vector<int>& corners) {
    for (std::size_t k = 2; k < corners.size(); ++k)
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

/// The next three numbers of a line.
inline Point<3> vertex_on_line(Words& words, std::string_view name) {
    Point<3> vertex;
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view digits = words.next_on_line();
        const auto value = number_of(digits);
        require(value.has_value(), name, ", line ", words.line(), ": coordinate ", "xyz"[axis], " of a vertex is ",
                quoted(digits), ", which is no number.");
        vertex[axis] = *value;
    }
    return vertex;
}

inline constexpr std::size_t most_corners = 0x7fffffff / 4;

} // namespace detail

/// The triangles of an STL file, binary or text. The length tells which it is, not the word "solid", with which binary
/// files may begin too.
/// @param bytes the whole file
/// @param unit the file's unit of length, m
/// @param name of the file, for messages
/// @throws Error that names the place, where the file is cut off or not STL
[[nodiscard]] inline Triangles parse_stl(std::string_view bytes, double unit, std::string_view name = "STL file") {
    detail::require_unit("parse_stl", unit);
    Triangles mesh;
    constexpr std::size_t head = 84, each = 50;
    const std::size_t number = bytes.size() >= head ? detail::number_at<std::uint32_t>(bytes, 80) : 0;
    const bool says_solid = bytes.substr(0, 5) == "solid";
    if (bytes.size() >= head && (bytes.size() == head + each * number || !says_solid)) {
        require(number <= (bytes.size() - head) / each, name, ": the file is ", bytes.size(),
                " bytes long; a binary STL of ", number, " triangles, as this says it is, has ", head + each * number,
                ". It is cut off, or no STL file.");
        require(number <= detail::most_corners, name, ": ", number, " triangles; at most ", detail::most_corners,
                " are allowed.");
        mesh.corners.reserve(3 * number);
        for (std::size_t t = 0; t < number; ++t) {
            std::array<Point<3>, 3> corners;
            for (std::size_t k = 0; k < 9; ++k)
                corners[k / 3][static_cast<int>(k % 3)] =
                    unit * static_cast<double>(detail::number_at<float>(bytes, head + each * t + 12 + 4 * k));
            detail::add_triangle(mesh, corners);
        }
    } else {
        require(says_solid, name, ": the file is ", bytes.size(),
                " bytes long and does not begin with \"solid\"; that is no STL file.");
        detail::Words words(bytes);
        std::array<Point<3>, 3> corners;
        std::size_t known = 0;
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            if (word == "vertex") {
                corners[known] = unit * detail::vertex_on_line(words, name);
                if (++known == 3) {
                    detail::add_triangle(mesh, corners);
                    known = 0;
                }
            }
        }
        require(known == 0, name, ": the text ends in the middle of a triangle.");
    }
    require(!mesh.triangles.empty(), name, ": no triangle is in the file.");
    return mesh;
}

/// The faces of an OBJ file; those of more than three corners become triangles around their first. Textures, normals,
/// groups and materials are skipped.
/// @param bytes the whole file
/// @param unit the file's unit of length, m
/// @param name of the file, for messages
/// @throws Error that names the line, where it is not OBJ
[[nodiscard]] inline Triangles parse_obj(std::string_view bytes, double unit, std::string_view name = "OBJ file") {
    detail::require_unit("parse_obj", unit);
    Triangles mesh;
    std::vector<int> face;
    for (detail::Words words(bytes); !words.at_end(); words.skip_line()) {
        const std::string_view what = words.next_on_line();
        if (what == "v") {
            require(mesh.corners.size() < detail::most_corners, name, ", line ", words.line(), ": at most ",
                    detail::most_corners, " vertices are allowed.");
            mesh.corners.push_back(unit * detail::vertex_on_line(words, name));
        } else if (what == "f") {
            face.clear();
            for (auto word = words.next_on_line(); !word.empty(); word = words.next_on_line()) {
                const auto number = detail::whole_number_of(word.substr(0, word.find('/')));
                const auto known = static_cast<long long>(mesh.corners.size());
                const long long corner = number.value_or(0) < 0 ? known + number.value_or(0) : number.value_or(0) - 1;
                require(number.has_value() && corner >= 0 && corner < known, name, ", line ", words.line(),
                        ": a face has corner ", detail::quoted(word), "; ", known,
                        " vertices are there, numbered from 1, or back from -1.");
                face.push_back(static_cast<int>(corner));
            }
            require(face.size() >= 3, name, ", line ", words.line(), ": a face has ", face.size(),
                    " corners; it must have at least 3.");
            detail::add_face(mesh, face);
        }
    }
    require(!mesh.triangles.empty(), name, ": no face is in the file.");
    return mesh;
}

namespace detail {

/// Reads the numbers of a PLY file's body in order, text or binary.
class PlyBody {
public:
    PlyBody(std::string_view bytes, std::string_view format, std::string_view name)
        : bytes_(bytes), words_(bytes), text_(format == "ascii"), little_(format == "binary_little_endian"),
          name_(name) {}
    /// The next number, of a type as named in the header.
    double next(std::string_view type) {
        if (text_) {
            const std::string_view word = words_.next();
            const auto value = number_of(word);
            require(value.has_value(), name_, ": in the body's line ", words_.line(), " is ", quoted(word),
                    " where a number should be.");
            return *value;
        }
        if (type == "char" || type == "int8")
            return take<std::int8_t>();
        if (type == "uchar" || type == "uint8")
            return take<std::uint8_t>();
        if (type == "short" || type == "int16")
            return take<std::int16_t>();
        if (type == "ushort" || type == "uint16")
            return take<std::uint16_t>();
        if (type == "int" || type == "int32")
            return take<std::int32_t>();
        if (type == "uint" || type == "uint32")
            return take<std::uint32_t>();
        if (type == "float" || type == "float32")
            return static_cast<double>(take<float>());
        require(type == "double" || type == "float64", name_, ": a property is of type ", quoted(type),
                ", which PLY does not have.");
        return take<double>();
    }

private:
    template <class T>
    T take() {
        require(bytes_.size() - at_ >= sizeof(T), name_, ": the file ends ", at_,
                " bytes behind its head, before all elements are there. It is cut off.");
        const T value = number_at<T>(bytes_, at_, little_);
        at_ += sizeof(T);
        return value;
    }

    std::string_view bytes_;
    Words words_;
    std::size_t at_ = 0;
    bool text_, little_;
    std::string_view name_;
};

} // namespace detail

/// The faces of a PLY file, text or binary in either byte order; those of more than three corners become triangles
/// around their first. Colours, normals and elements other than vertices and faces are skipped.
/// @param bytes the whole file
/// @param unit the file's unit of length, m
/// @param name of the file, for messages
/// @throws Error where the file is cut off or not PLY
[[nodiscard]] inline Triangles parse_ply(std::string_view bytes, double unit, std::string_view name = "PLY file") {
    detail::require_unit("parse_ply", unit);
    struct Property {
        std::string_view type, length_type, name; // for a list, the type of its length; else empty
    };
    struct Element {
        std::string_view name;
        long long number;
        std::vector<Property> properties;
    };
    std::vector<Element> elements;
    std::string_view format;
    detail::Words words(bytes);
    require(words.next() == "ply", name, ": the file does not begin with \"ply\"; that is no PLY file.");
    for (bool in_head = true; in_head; words.skip_line()) {
        require(!words.at_end(), name, ": the head of the file has no end (end_header).");
        const std::string_view what = words.next_on_line();
        if (what == "format") {
            format = words.next_on_line();
            require(format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian", name,
                    ": the format is ", detail::quoted(format),
                    "; it must be ascii, binary_little_endian or binary_big_endian.");
        } else if (what == "element") {
            const std::string_view element = words.next_on_line(), digits = words.next_on_line();
            const auto number = detail::whole_number_of(digits);
            require(number && *number >= 0 && *number <= static_cast<long long>(detail::most_corners), name, ", line ",
                    words.line(), ": there are ", detail::quoted(digits), " of element ", detail::quoted(element),
                    "; the number must be from 0 to ", detail::most_corners, ".");
            elements.push_back({element, *number, {}});
        } else if (what == "property") {
            require(!elements.empty(), name, ", line ", words.line(), ": a property comes before any element.");
            Property property{words.next_on_line(), {}, {}};
            if (property.type == "list") {
                property.length_type = words.next_on_line();
                property.type = words.next_on_line();
            }
            property.name = words.next_on_line();
            elements.back().properties.push_back(property);
        }
        in_head = what != "end_header";
    }
    require(!format.empty(), name, ": the head of the file does not say its format.");
    detail::PlyBody body(bytes.substr(words.place()), format, name);
    Triangles mesh;
    std::vector<double> numbers;
    std::vector<std::vector<int>> faces;
    for (const Element& element : elements)
        for (long long k = 0; !element.properties.empty() && k < element.number; ++k) {
            const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
            Point<3> corner = Point<3>::Zero();
            for (const Property& property : element.properties) {
                numbers.clear();
                const double length = property.length_type.empty() ? 1 : body.next(property.length_type);
                require(length >= 0 && length <= 1e6, name, ": a list of ", element.name, " ", k, " has ", length,
                        " numbers; from 0 to 1e6 are allowed.");
                for (double i = 0; i < length; ++i)
                    numbers.push_back(body.next(property.type));
                for (int axis = 0; axis < 3; ++axis)
                    if (is_vertex && property.length_type.empty() &&
                        property.name == std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1))
                        corner[axis] = unit * numbers.front();
                if (is_face && (property.name == "vertex_indices" || property.name == "vertex_index")) {
                    auto& face = faces.emplace_back();
                    for (const double number : numbers) {
                        require(number >= 0 && number < static_cast<double>(detail::most_corners), name, ": face ", k,
                                " has corner ", number, "; corners are numbered from 0.");
                        face.push_back(static_cast<int>(number));
                    }
                }
            }
            if (is_vertex)
                mesh.corners.push_back(corner);
        }
    for (const auto& face : faces) {
        for (const int corner : face)
            require(static_cast<std::size_t>(corner) < mesh.corners.size(), name, ": a face has corner ", corner,
                    "; there are ", mesh.corners.size(), " vertices, numbered from 0.");
        detail::add_face(mesh, face);
    }
    require(!mesh.triangles.empty(), name, ": no face is in the file. A cloud of points has no inside.");
    return mesh;
}

/// The triangles of a file of the type given by its ending, .stl, .obj or .ply, in metres:
///
///     const TriangleMesh gear(read_mesh("gear.stl", millimetres));
///
/// None of these files stores its unit, and most are in millimetres, so it must be given.
/// @param path the file
/// @param unit the file's unit of length, m
/// @throws Error where the file cannot be read, is damaged, or is of another kind
[[nodiscard]] inline Triangles read_mesh(const std::filesystem::path& path, double unit) {
    detail::require_unit("read_mesh", unit);
    std::string kind = path.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    require(kind == ".stl" || kind == ".obj" || kind == ".ply", "read_mesh: ", path.string(), " ends with \"", kind,
            "\"; meshes are read from .stl, .obj and .ply. Convert it, or call parse_stl, ",
            "parse_obj or parse_ply with its bytes.");
    const std::string bytes = detail::bytes_of_file("read_mesh", path), name = path.string();
    return kind == ".stl"   ? parse_stl(bytes, unit, name)
           : kind == ".obj" ? parse_obj(bytes, unit, name)
                            : parse_ply(bytes, unit, name);
}

} // namespace imbibe
