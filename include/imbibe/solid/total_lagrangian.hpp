// The total-Lagrangian solid: everything it is made of, in one include.
//
//   struct Sponge : Solid<ReferenceCorrection<>,          // once: L = M^-1 from the stress-free neighbours
//                         DeformationGradient<>,          // u -> F
//                         StVenantKirchhoff,              // F -> P (or NeoHookean)
//                         TotalLagrangianForce<>,         // P, L -> dv/dt
//                         HourglassControl<>,             // against what F does not see
//                         TotalLagrangianViscosity<>> {}; // if it should stop ringing
//
// All terms must have the same kernel where they share neighbours; WendlandC2 with a support of 2.6 spacings is what
// they were tried with. The density stays that of the stress-free solid.
#pragma once

#include <imbibe/solid/cauchy_stress.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/displacement.hpp>
#include <imbibe/solid/first_piola.hpp>
#include <imbibe/solid/hourglass_control.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/reference_correction.hpp>
#include <imbibe/solid/st_venant_kirchhoff.hpp>
#include <imbibe/solid/total_lagrangian_force.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
