// Scenes that several tests of this room run: one type each, so that the compiler meets it once.
#pragma once

#include <imbibe/fluid/continuity.hpp>
#include <imbibe/fluid/symmetric_pressure.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/solid/total_lagrangian.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/time/symplectic_euler.hpp>

namespace monitor_test {

namespace sph = imbibe;
using K = sph::WendlandC2;

/// Particles without any force but their weight.
struct Dust : sph::Fluid<> {};
template <int dim>
using DustScene = sph::Solver<dim, double, sph::SymplecticEuler, Dust>;

struct Water : sph::Fluid<sph::LinearState, sph::Continuity<K>, sph::SymmetricPressure<K>> {};
template <int dim, class Real = double>
using Pool = sph::Solver<dim, Real, sph::SymplecticEuler, Water>;

/// A total-Lagrangian solid.
template <class Law>
struct Block : sph::Solid<sph::ReferenceCorrection<K>, sph::DeformationGradient<K>, Law, sph::TotalLagrangianForce<K>> {
};
template <int dim, class Law>
using BlockScene = sph::Solver<dim, double, sph::SymplecticEuler, Block<Law>>;

} // namespace monitor_test
