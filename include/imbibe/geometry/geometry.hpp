// The whole geometry room in one include, except readers of meshes and images: those are in input/input.hpp.
#pragma once

#include <imbibe/geometry/box.hpp>
#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/cylinder.hpp>
#include <imbibe/geometry/distinct.hpp>
#include <imbibe/geometry/facets.hpp>
#include <imbibe/geometry/fill.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/geometry/foam.hpp>
#include <imbibe/geometry/half_space.hpp>
#include <imbibe/geometry/jitter.hpp>
#include <imbibe/geometry/level_set.hpp>
#include <imbibe/geometry/passage.hpp>
#include <imbibe/geometry/point.hpp>
#include <imbibe/geometry/pore_report.hpp>
#include <imbibe/geometry/pores.hpp>
#include <imbibe/geometry/sampling.hpp>
#include <imbibe/geometry/shape.hpp>
#include <imbibe/geometry/sphere.hpp>
#include <imbibe/geometry/tank.hpp>
#include <imbibe/geometry/transform.hpp>
#include <imbibe/geometry/triply_periodic.hpp>
