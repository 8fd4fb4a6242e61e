// Small meshes for tests, with corners of their own for every triangle, as STL files have them.
#pragma once

#include <imbibe/geometry/mesh.hpp>

#include <array>
#include <vector>

namespace small_meshes {

using imbibe::Point;
using imbibe::Triangles;

inline void add(Triangles& mesh, const Point<3>& a, const Point<3>& b, const Point<3>& c) {
    const auto first = static_cast<int>(mesh.corners.size());
    mesh.corners.insert(mesh.corners.end(), {a, b, c});
    mesh.triangles.push_back({first, first + 1, first + 2});
}

/// A box of n x n x 2 triangles a side, facing outwards.
inline Triangles box(const Point<3>& lower, const Point<3>& upper, int n = 1) {
    Triangles mesh;
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
                    const auto at = [&](int x, int y) {
                        Point<3> p;
                        p[axis] = end == 0 ? lower[axis] : upper[axis];
                        p[u] = lower[u] + (upper[u] - lower[u]) * x / n;
                        p[v] = lower[v] + (upper[v] - lower[v]) * y / n;
                        return p;
                    };
                    const Point<3> a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
                    if (end == 1)
                        add(mesh, a, b, c), add(mesh, a, c, d);
                    else
                        add(mesh, a, c, b), add(mesh, a, d, c);
                }
    return mesh;
}

/// A ball of 8 * 4^times triangles.
inline Triangles ball(const Point<3>& centre, double radius, int times) {
    std::vector<std::array<Point<3>, 3>> faces;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) {
                const Point<3> a(x, 0, 0), b(0, y, 0), c(0, 0, z);
                faces.push_back(x * y * z > 0 ? std::array{a, b, c} : std::array{a, c, b});
            }
    for (; times > 0; --times) {
        std::vector<std::array<Point<3>, 3>> finer;
        for (const auto& [a, b, c] : faces) {
            const Point<3> ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces.swap(finer);
    }
    Triangles mesh;
    for (const auto& [a, b, c] : faces)
        add(mesh, centre + radius * a, centre + radius * b, centre + radius * c);
    return mesh;
}

inline Triangles turned(Triangles mesh) {
    for (auto& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

inline Triangles operator+(Triangles a, const Triangles& b) {
    const auto first = static_cast<int>(a.corners.size());
    a.corners.insert(a.corners.end(), b.corners.begin(), b.corners.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return a;
}

} // namespace small_meshes
