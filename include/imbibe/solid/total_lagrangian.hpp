// The total-Lagrangian solid: everything it is made of, in one include.
//
//   struct Sponge : Solid<ReferenceCorrection<>,          // once: L = M^-1 from the stress-free neighbours
//                         DeformationGradient<>,          // u -> F
//                         StVenantKirchhoff,              // F -> P (or CompressibleNeoHookean, IsochoricNeoHookean,
//                                                         //    VolumetricDeviatoric: nu near 1/2)
//                         TotalLagrangianForce<>,         // P, L -> dv/dt
//                         HourglassControl<>,             // against what F does not see
//                         TotalLagrangianViscosity<>> {}; // if it should stop ringing
//
// ReferenceCorrection, DeformationGradient and TotalLagrangianForce must have the same kernel, or momentum and energy
// are not conserved. The density stays that of the stress-free solid.
//
// A particle's neighbours are only those within the support radius in the stress-free state. So bodies of one phase
// that start nearer than that are one body. Others pass through each other, and a body through itself, unless the phase
// lists KernelRepulsion<> with a range of 0.9 (spacings; never 0, the whole support, within a solid), or each body is a
// phase of its own and a coupling of the two has the repulsion. Within one phase it makes steps shorter.
//
// Give the solid a support of its own, 1.5 to 2 spacings. The neighbours never change, so these few are enough, and
// bending is less soft: the strains that surface particles see are averaged inwards. The period of a clamped plate
// (Gray et al. 2001, 2D, small swings) is too long by
//     particles across   support 1.5   support 2    support 2.6 spacings
//            4               6 %          17 %          28 %
//            6               4 %           9 %          13 %
//           10               2 %           4 %           5 %
// Of that, 1/(2 n^2) with n particles across comes from the sum over the layers, for any support: bending_modulus.
#pragma once

#include <imbibe/solid/bending_modulus.hpp>
#include <imbibe/solid/cauchy_stress.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/displacement.hpp>
#include <imbibe/solid/finite_strain_limit.hpp>
#include <imbibe/solid/first_piola.hpp>
#include <imbibe/solid/hourglass_control.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/reference_correction.hpp>
#include <imbibe/solid/st_venant_kirchhoff.hpp>
#include <imbibe/solid/total_lagrangian_force.hpp>
#include <imbibe/solid/total_lagrangian_viscosity.hpp>
