// The effective stiffness of a porous body, and the deformation of its pores under compression: a periodic cell of
// elastic particles under a mean strain.
#pragma once

#include <imbibe/geometry/combine.hpp>
#include <imbibe/geometry/fitted.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/dynamic_relaxation.hpp>
#include <imbibe/porous/cell.hpp>
#include <imbibe/solid/deformation_gradient.hpp>
#include <imbibe/solid/hourglass_control.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/solid/total_lagrangian_force.hpp>
#include <imbibe/solver/solver.hpp>
#include <imbibe/time/symplectic_euler.hpp>

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace imbibe {

namespace detail {

/// The mean gradient of the displacement, H_ij = d u_i/d X_j, no unit.
struct MeanStrainParameters {
    double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0; ///< H_ij

    /// Are the two the same?
    bool operator==(const MeanStrainParameters&) const = default;
};

/// `Law` at the deformation gradient F + H: the solid's displacement is H X + u, of which the particles move by u only,
/// because u is periodic and H X is not. The other terms of a total-Lagrangian solid see u only.
///
/// Source: the first-order homogenisation of periodic cells, for instance Michel, Moulinec and Suquet (1999).
template <class Law>
struct UnderMeanStrain {
    using Parameters = MeanStrainParameters;
    static constexpr bool of_solids = true;
    static constexpr double greatest_poisson_ratio = Law::greatest_poisson_ratio;
    using reads = Fields<deformation_gradient>;
    using sets = Fields<first_piola_stress>;
    static constexpr bool in_packs = true;
    Parameters parameters{};

    template <class A>
    struct Strained { // a particle as Law sees it
        using Scalar = typename A::Scalar;
        static constexpr int dimension = A::dimension;
        const typename A::Material& material;
        Tensor<Scalar, dimension> F;
        IMBIBE_INLINE constexpr const auto& operator[](decltype(deformation_gradient)) const { return F; }
    };

    IMBIBE_INLINE constexpr auto operator()(const auto& a) const {
        using A = std::remove_cvref_t<decltype(a)>;
        using T = typename A::Scalar;
        const double H[]{parameters.xx, parameters.xy, parameters.xz, parameters.yx, parameters.yy,
                         parameters.yz, parameters.zx, parameters.zy, parameters.zz};
        Tensor<T, A::dimension> F = a[deformation_gradient];
        for (int i = 0; i < A::dimension; ++i)
            for (int j = 0; j < A::dimension; ++j)
                F(i, j) += T(H[3 * i + j]);
        return Law{}(Strained<A>{a.material, F});
    }

    static constexpr const char* limit_name = Law::limit_name;
    /// The limit of the law, s.
    static double time_step_limit(const auto& material, const TimeStepInput& in) {
        return Law::time_step_limit(material, in);
    }
};

} // namespace detail

namespace porous {

/// The elastic body of a periodic cell. Units: of length the spacing, of density its own, of stress its Young's
/// modulus.
struct Skeleton : Solid<ReferenceCorrection<WendlandC2>, DeformationGradient<WendlandC2>,
                        detail::UnderMeanStrain<CompressibleNeoHookean>, TotalLagrangianForce<WendlandC2>,
                        HourglassControl<WendlandC2>> {};

} // namespace porous

/// Settings of strained() and elastic_moduli().
struct SkeletonRun {
    double poisson_ratio = 0.3; ///< of the material; 0 to 0.45
    double support = 2;         ///< of the kernel, spacings; 1.5 to 3. For particles along the lattice 1.5 suffices
    double left = 1e-3;         ///< ends when the relative change of the mean stress is below this; 1e-6 to 0.1
    long long steps = 200000;   ///< ends with an Error if it has not converged after this many
    int threads = 0;            ///< 1 to 1024; 0: all of the machine
};

/// A periodic cell of an elastic body at rest under a mean strain.
struct Strained {
    std::vector<Point<3>> body; ///< present positions of the particles, m: X + H X + u
    Eigen::Matrix3d stress;     ///< mean first Piola-Kirchhoff stress over the cell, in Young's moduli of the body
    double left = 0;            ///< relative change of the stress at the end
    long long steps = 0;        ///< time steps that it took
};

/// Applies a mean strain to a periodic cell of an elastic body and lets it come to rest: x = X + H X + u with a
/// periodic u. The stress is the mean over the cell, which does its work on H (Hill and Mandel).
///
/// The strain is applied in parts of 2 %. After each the body oscillates, critically damped at its dominant frequency
/// (dynamic relaxation, Underwood 1983), until the stress is steady.
///
/// There is no contact: parts of the body that meet pass through each other. Loose pieces are not strained. A body that
/// bears less than 1e-5 of the material's stress counts as one that bears nothing. Not for struts thinner than 4
/// spacings: they are too soft.
/// @param body places of the particles in the stress-free cell, m
/// @param cell the periodic cell, m
/// @param spacing of the particles, m
/// @param gradient H_ij = d u_i/d X_j; no principal stretch may be below 0.2
/// @param run how
/// @throws Error for numbers out of range, and if it is not at rest after SkeletonRun::steps
[[nodiscard]] inline Strained strained(const std::vector<Point<3>>& body, const Box<3>& cell, double spacing,
                                       const Eigen::Matrix3d& gradient, const SkeletonRun& run = {}) {
    constexpr const char* who = "strained";
    detail::require_positive(who, "spacing", spacing, "Give the distance between particles in metres.");
    require(cell.bounded(), who, ": the cell must be bounded. Give two corners.");
    require(!body.empty(), who, ": there are no particles of the body.");
    require(gradient.allFinite(), who, ": the mean gradient of the displacement has a component that is not finite.");
    require((Eigen::Matrix3d::Identity() + gradient).jacobiSvd().singularValues().minCoeff() >= 0.2, who,
            ": a mean strain with a principal stretch below 0.2; pores would be closed. Squeeze less.");
    require(run.poisson_ratio >= 0 && run.poisson_ratio <= 0.45, who,
            ": SkeletonRun::poisson_ratio = ", run.poisson_ratio, " must be from 0 to 0.45.");
    require(run.support >= 1.5 && run.support <= 3, who, ": SkeletonRun::support = ", run.support,
            " spacings; it must be from 1.5 to 3.");
    require(run.left >= 1e-6 && run.left <= 0.1, who, ": SkeletonRun::left = ", run.left, " must be from 1e-6 to 0.1.");
    require(run.steps >= 1, who, ": SkeletonRun::steps = ", run.steps, " must be at least 1.");

    std::vector<Point<3>> places(body.size()); // in spacings
    for (std::size_t i = 0; i < body.size(); ++i)
        places[i] = (body[i] - cell.lower()) / spacing;
    const Point<3> size = cell.size() / spacing;
    Settings<3> settings{
        .support_radius = run.support, .cfl = 0.5, .max_time_step = 1, .threads = run.threads, .on_warning = {}};
    for (int k = 0; k < 3; ++k)
        settings.periodic_length[static_cast<std::size_t>(k)] = size[k];
    Solver<3, double, SymplecticEuler, porous::Skeleton> scene(settings);
    const double nu = run.poisson_ratio;
    const auto skeleton = scene.add(
        porous::Skeleton{
            {.density = 1, .sound_speed = std::sqrt(1 / (3 * (1 - 2 * nu))), .shear_modulus = 1 / (2 * (1 + nu))}},
        places, 1);
    auto view = scene[skeleton];

    Strained found{};
    const auto mean_stress = [&] {
        Eigen::Matrix3d sum;
        const auto P = view[first_piola_stress];
        const auto share = view[stress_share]; // share of its stress that a particle bears
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                sum(i, j) = P.col(3 * i + j).dot(share.col(0)) / size.prod();
        return sum;
    };
    DynamicRelaxation relaxation;
    const int parts = std::max(1, static_cast<int>(std::ceil(gradient.norm() / 0.02)));
    for (int part = 1; part <= parts; ++part) {
        const Eigen::Matrix3d H = gradient * part / parts;
        view.material().set(detail::MeanStrainParameters{H(0, 0), H(0, 1), H(0, 2), H(1, 0), H(1, 1), H(1, 2), H(2, 0),
                                                         H(2, 1), H(2, 2)});
        if (part > 1) // first guess by proportional growth
            view[position] += (view[position] - view[reference_position]) / (part - 1.0);
        const double enough = part == parts ? run.left : 0.1;
        Eigen::Matrix3d before = mean_stress();
        double last = scene.time();
        for (int steady = 0, step = 1; steady < 3; ++step) {
            require(found.steps < run.steps, who, ": after ", found.steps,
                    " steps the body is not at rest; its stress still changes by ", 100 * found.left,
                    " %. Loose or thin parts swing long: drop loose pieces, allow more SkeletonRun::steps or a larger ",
                    "SkeletonRun::left.");
            scene.step();
            ++found.steps;
            relaxation(view, scene.time());
            if (step % 10 != 0)
                continue;
            const Eigen::Matrix3d stress = mean_stress();
            found.left = (stress - before).norm() / std::max({stress.norm(), 1e-5 * H.norm(), 1e-30}) *
                         std::max(1.0, 2 / (std::max(relaxation.rate(), 1e-6) * (scene.time() - last)));
            steady = found.left < enough ? steady + 1 : 0;
            before = stress;
            last = scene.time();
        }
        found.stress = before;
    }
    found.body.resize(body.size());
    for (Eigen::Index row = 0; row < view.size(); ++row) {
        const std::size_t i = view.ids()[static_cast<std::size_t>(row)];
        const Point<3> u = (view[position].row(row) - view[reference_position].row(row)).transpose();
        found.body[i] = cell.lower() + spacing * (places[i] + gradient * places[i] + u);
    }
    return found;
}

/// The effective stiffness of a porous body, in Young's moduli of its material.
struct ElasticModuli {
    /// Mean stress over mean strain, both in the order xx, yy, zz, yz, xz, xy, with the doubled shear strains (Voigt):
    /// row for the stress, column for the strain.
    Eigen::Matrix<double, 6, 6> stiffness;
    /// Expected change of each with a finer spacing; 0: not known.
    Eigen::Matrix<double, 6, 6> error = Eigen::Matrix<double, 6, 6>::Zero();
    double porosity = 0; ///< share of the particles that are not body, 0 to 1

    /// Young's modulus along an axis (0, 1, 2), free sideways.
    [[nodiscard]] double young(int axis) const { return 1 / compliance()(axis, axis); }
    /// Poisson's ratio: the contraction along `across` under tension along `along`.
    [[nodiscard]] double poisson(int along, int across) const {
        const Eigen::Matrix<double, 6, 6> S = compliance();
        return -S(across, along) / S(along, along);
    }
    /// The shear modulus of the plane normal to an axis.
    [[nodiscard]] double shear(int axis) const { return 1 / compliance()(3 + axis, 3 + axis); }

private:
    [[nodiscard]] Eigen::Matrix<double, 6, 6> compliance() const { return stiffness.inverse(); }
};

/// The elastic moduli of a shape in its bounds, which are taken as a periodic cell: six small strains of strained(),
/// each of 1e-4, at the spacing and at one about 1.5 times as wide. The main error is that faces are too soft. It is
/// proportional to the spacing, so the two results are extrapolated to zero spacing; ElasticModuli::error is the
/// correction. If it is more than a third of the diagonal, struts are hardly resolved, and the moduli are left as they
/// are at the spacing.
///
/// Not for shapes that are not connected: some moduli are then zero, and young() is not defined.
/// @param shape the body; one that is not periodic across the sides of its bounds is mirrored first
/// @param spacing of the particles, m; each side of the bounds must be a whole number of spacings
/// @param run settings; SkeletonRun::left is of each of the six strains
/// @throws Error as strained() and fitted() do
template <AnyShape S>
requires(shape_dimension<S> == 3) [[nodiscard]] ElasticModuli
    elastic_moduli(const S& shape, double spacing, const SkeletonRun& run = {}) {
    const Box<3> cell = shape.bounds();
    detail::require_whole_spacings("elastic_moduli", cell, spacing);
    ElasticModuli found;
    const auto at = [&](double of) {
        const auto body = fitted_together(of, cell.lower(), 0, shape, cell - shape)[0];
        found.porosity = 1 - static_cast<double>(body.size()) * power<3>(of) / cell.volume();
        Eigen::Matrix<double, 6, 6> stiffness;
        constexpr int first[]{0, 1, 2, 1, 0, 0}, second[]{0, 1, 2, 2, 2, 1};
        constexpr double strain = 1e-4;
        for (int column = 0; column < 6; ++column) {
            Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
            gradient(first[column], second[column]) += strain / 2;
            gradient(second[column], first[column]) += strain / 2;
            const Eigen::Matrix3d stress = strained(body, cell, of, gradient, run).stress;
            for (int row = 0; row < 6; ++row)
                stiffness(row, column) =
                    (stress(first[row], second[row]) + stress(second[row], first[row])) / 2 / strain;
        }
        return stiffness;
    };
    const double wide = detail::wider_spacing(cell, spacing);
    const Eigen::Matrix<double, 6, 6> coarse = wide > 0 ? at(wide) : Eigen::Matrix<double, 6, 6>::Zero();
    found.stiffness = at(spacing);
    if (wide > 0) {
        const Eigen::Matrix<double, 6, 6> more = (found.stiffness - coarse) / (wide / spacing - 1);
        found.error = more.cwiseAbs();
        if ((found.error.diagonal().array() < found.stiffness.diagonal().array() / 3).all())
            found.stiffness += more;
    }
    return found;
}

} // namespace imbibe
