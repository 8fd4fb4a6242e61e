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
// ReferenceCorrection, DeformationGradient and TotalLagrangianForce must have the same kernel: momentum and energy
// hang on it. The density stays that of the stress-free solid.
//
// Particles see those only that were within the support radius when they were free of stress. So bodies of one phase
// that lie nearer to each other at the start are one body, and others pass through each other, and a body through
// itself, unless the phase lists KernelRepulsion<> with a range of 0.9 (spacings; never 0, the whole support, within a
// solid), or each body is a phase of its own and a coupling of the two has it; within one phase steps are shorter.
//
// Give the solid a support of its own, 1.5 to 2 spacings. The neighbours never change, so these few are enough, and
// what bends is less soft: particles at a surface see strains that are averaged inwards. The period of a clamped plate
// (Gray et al. 2001, 2D, small swings) came out too long by
//     particles across   support 1.5   support 2    support 2.6 spacings
//            4               6 %          17 %          28 %
//            6               4 %           9 %          13 %
//           10               2 %           4 %           5 %
// Of that, 1/(2 n^2) with n particles across is the sum over the layers, whatever the support: bending_modulus.
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
