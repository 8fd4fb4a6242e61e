// All smoothing kernels.
#pragma once

#include <imbibe/kernels/cubic_spline.hpp>
#include <imbibe/kernels/kernel.hpp>
#include <imbibe/kernels/poly6.hpp>
#include <imbibe/kernels/quintic_spline.hpp>
#include <imbibe/kernels/spiky.hpp>
#include <imbibe/kernels/viscosity_kernel.hpp>
#include <imbibe/kernels/wendland.hpp>
