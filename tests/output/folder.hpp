// The folder in which the tests of this room leave their files for read_vtk.py.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace output_test {

inline const std::filesystem::path folder = IMBIBE_OUTPUT_TEST_FOLDER;

/// An empty folder of its own for one test.
inline std::filesystem::path fresh(const std::string& name) {
    const auto path = folder / name;
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

/// All bytes of a file.
inline std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace output_test
