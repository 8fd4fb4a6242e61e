// Bodies from files in one include: meshes and images, their readers and their reports. Not part of imbibe.hpp, whose
// compilation would take half as long again.
#pragma once

#include <imbibe/geometry/image_report.hpp>
#include <imbibe/geometry/mesh_report.hpp>
#include <imbibe/input/read_image.hpp>
#include <imbibe/input/read_mesh.hpp>
