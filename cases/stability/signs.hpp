// What cases of the gauntlet measure: distances of pairs, roughness of pressure, density and displacement.
#pragma once

#include <imbibe/kernels/wendland.hpp>
#include <imbibe/monitor/energy.hpp>
#include <imbibe/solid/first_piola.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <vector>

namespace stability {

namespace sph = imbibe;

/// The least distance of two particles of a phase, in spacings (at most 1). Scenes are small: all pairs are looked at.
template <class View>
double closest_pair(const View& phase) {
    const auto x = phase[sph::position];
    double least = sph::sq(phase.material().spacing);
    for (int i = 0; i < phase.size(); ++i)
        for (int j = 0; j < i; ++j)
            least = std::min(least, static_cast<double>((x.row(i) - x.row(j)).squaredNorm()));
    return std::sqrt(least) / phase.material().spacing;
}

/// Root mean square of a scalar field less its mean over the neighbours nearer than 1.5 spacings: what alternates from
/// particle to particle (a checkerboard). Particles with fewer than 4 such neighbours are left out.
template <class View, class Field>
double alternating(const View& phase, Field field) {
    const auto x = phase[sph::position];
    const auto f = phase[field];
    const double near = sph::sq(1.5 * phase.material().spacing);
    double squares = 0;
    int number = 0;
    for (int i = 0; i < phase.size(); ++i) {
        double sum = 0;
        int found = 0;
        for (int j = 0; j < phase.size(); ++j)
            if (j != i && static_cast<double>((x.row(i) - x.row(j)).squaredNorm()) < near) {
                sum += static_cast<double>(f(j));
                ++found;
            }
        if (found >= 4) {
            squares += sph::sq(static_cast<double>(f(i)) - sum / found);
            ++number;
        }
    }
    return number > 0 ? std::sqrt(squares / number) : 0;
}

/// The least sum of V W (WendlandC2, 3 spacings) of a particle for which `counts(x)`: below 1 there is a void.
template <class View, class Counts>
double least_concentration(const View& phase, const Counts& counts) {
    const auto x = phase[sph::position];
    const double spacing = phase.material().spacing, H = 3 * spacing;
    constexpr int dim = decltype(x)::ColsAtCompileTime;
    double least = 1;
    for (int i = 0; i < phase.size(); ++i) {
        if (!counts(x.row(i)))
            continue;
        double sum = 0;
        for (int j = 0; j < phase.size(); ++j)
            if (const double r = static_cast<double>((x.row(i) - x.row(j)).norm()); r < H)
                sum += sph::power<dim>(spacing) * sph::kernel_value<sph::WendlandC2, dim>(r, H);
        least = std::min(least, sum);
    }
    return least;
}

/// How far a particle is below the floor (y = 0) or beyond the side x = `right`, in space also z = `right`, in spacings.
/// At least 0.
template <class View>
double way_into_wall(const View& phase, double right) {
    const auto x = phase[sph::position];
    const double deepest = std::max(-static_cast<double>(x.col(1).minCoeff()),
                                    static_cast<double>(x(Eigen::all, Eigen::seq(0, Eigen::last, 2)).maxCoeff()) - right);
    return std::max(deepest, 0.0) / phase.material().spacing;
}

/// The lattice that a solid starts from: its points, and which of those that count have all their nearest neighbours.
class Lattice {
public:
    struct Inner {
        std::size_t at;
        std::vector<std::size_t> around;
    };
    template <class Points, class Counts>
    Lattice(const Points& points, double spacing, const Counts& counts) {
        for (const auto& x : points) {
            start_.push_back(Eigen::Vector3d::Zero());
            for (int d = 0; d < static_cast<int>(x.size()); ++d)
                start_.back()[d] = x[d];
            dim_ = static_cast<int>(x.size());
        }
        std::map<std::array<long, 3>, std::size_t> lattice;
        const auto place = [&](const Eigen::Vector3d& x) {
            std::array<long, 3> at;
            for (int d = 0; d < 3; ++d)
                at[static_cast<std::size_t>(d)] = std::lround((x[d] - start_[0][d]) / spacing);
            return at;
        };
        for (std::size_t k = 0; k < start_.size(); ++k)
            if (counts(points[k]))
                lattice[place(start_[k])] = k;
        for (const auto& [here, k] : lattice) {
            std::vector<std::size_t> around;
            for (std::size_t d = 0; d < static_cast<std::size_t>(dim_); ++d)
                for (const long step : {-1L, 1L}) {
                    auto at = here;
                    at[d] += step;
                    if (const auto found = lattice.find(at); found != lattice.end())
                        around.push_back(found->second);
                }
            if (around.size() == static_cast<std::size_t>(2 * dim_))
                inner_.push_back({k, around});
        }
    }
    int dim() const { return dim_; }
    const std::vector<Eigen::Vector3d>& start() const { return start_; }
    const std::vector<Inner>& inner() const { return inner_; }

private:
    int dim_ = 2;
    std::vector<Eigen::Vector3d> start_;
    std::vector<Inner> inner_;
};

/// How rough the displacements of a solid are: the lattice it started from, found again by the ids of its particles.
class Roughness {
public:
    template <class Points>
    Roughness(const Points& points, double spacing)
        : spacing_(spacing), lattice_(points, spacing, [](const auto&) { return true; }) {}
    /// The greatest deviation of a displacement from the mean of its nearest neighbours', in spacings.
    template <class View>
    double operator()(const View& phase) const {
        const auto x = phase[sph::position];
        std::vector<Eigen::Vector3d> moved(lattice_.start().size());
        for (int i = 0; i < phase.size(); ++i) {
            const std::size_t id = phase.ids()[static_cast<std::size_t>(i)];
            moved[id].setZero();
            for (int d = 0; d < lattice_.dim(); ++d)
                moved[id][d] = static_cast<double>(x(i, d)) - lattice_.start()[id][d];
        }
        double most = 0;
        for (const auto& [at, around] : lattice_.inner()) {
            Eigen::Vector3d mean = Eigen::Vector3d::Zero();
            for (const std::size_t k : around)
                mean += moved[k] / static_cast<double>(around.size());
            const double off = (moved[at] - mean).norm() / spacing_;
            if (!(off <= most))
                most = off;
        }
        return most;
    }

private:
    double spacing_;
    Lattice lattice_;
};

/// Which share of a solid's mean stress alternates from particle to particle (a checkerboard): its root mean square
/// less that of the nearest neighbours on the lattice, over that of itself, each as a mean over the times that were
/// looked at. Above a half there is more of it than of the stress.
class AlternatingMeanStress {
public:
    /// @param counts of a point where it starts: only such are looked at, and as neighbours of such
    template <class Points, class Counts>
    AlternatingMeanStress(const Points& points, double spacing, const Counts& counts)
        : lattice_(points, spacing, counts) {}
    /// Looks once more, and gives the share up to now.
    template <class View>
    double operator()(const View& phase) {
        std::vector<double> stress(lattice_.start().size());
        for (int i = 0; i < phase.size(); ++i)
            stress[phase.ids()[static_cast<std::size_t>(i)]] = mean_stress(phase, i);
        double off = 0, itself = 0;
        for (const auto& [at, around] : lattice_.inner()) {
            double mean = 0;
            for (const std::size_t k : around)
                mean += stress[k] / static_cast<double>(around.size());
            off += sph::sq(stress[at] - mean);
            itself += sph::sq(stress[at]);
        }
        alternating_ += std::sqrt(off);
        all_ += std::sqrt(itself);
        return alternating_ / std::max(all_, 1e-300);
    }

private:
    Lattice lattice_;
    double alternating_ = 0, all_ = 0;

    // tr sigma/dim, Pa, with sigma = P F^T/J where the law gives P, else from the pressure
    template <class View>
    static double mean_stress(const View& phase, int i) {
        using State = std::remove_cvref_t<decltype(phase.state)>;
        constexpr int dim = std::remove_cvref_t<decltype(phase[sph::position])>::ColsAtCompileTime;
        if constexpr (State::template stores<sph::FirstPiolaStress>) {
            Eigen::Matrix<double, dim, dim> F, P;
            for (int k = 0; k < dim * dim; ++k) {
                F(k / dim, k % dim) = static_cast<double>(phase[sph::deformation_gradient](i, k));
                P(k / dim, k % dim) = static_cast<double>(phase[sph::first_piola_stress](i, k));
            }
            return F.cwiseProduct(P).sum() / (dim * F.determinant());
        } else
            return -static_cast<double>(phase[sph::pressure](i));
    }
};

/// Gives all particles of a phase velocities that are evenly distributed up to `most`, m/s, the same in every run.
template <class View>
void shake(const View& phase, double most, unsigned seed = 1) {
    std::mt19937 generator(seed);
    const auto next = [&] { return 2.0 * static_cast<double>(generator()) / 4294967295.0 - 1; };
    auto v = phase[sph::velocity];
    using Number = std::remove_cvref_t<decltype(v(0, 0))>;
    for (int i = 0; i < phase.size(); ++i)
        for (Eigen::Index d = 0; d < v.cols(); ++d)
            v(i, d) += static_cast<Number>(most * next());
}

/// Kinetic energy as a multiple of that of the first call.
class Growth {
public:
    template <class View>
    double operator()(const View& phase) {
        const double now = sph::kinetic_energy(phase);
        if (first_ < 0)
            first_ = now;
        return now / first_;
    }

private:
    double first_ = -1;
};

} // namespace stability
