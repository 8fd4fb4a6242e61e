// Results from neighbour lists without terms: the distance of the nearest pair, the number of neighbours, and the share
// of a particle's surroundings that another phase fills.
#pragma once

#include <imbibe/core/parallel.hpp>
#include <imbibe/kernels/wendland.hpp>
#include <imbibe/search/neighbours.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace imbibe::detail {

/// The pairs of two phases, or of one with itself, from its list of runs.
template <int dim, class Real, int width>
class IMBIBE_PER_BUILD PairDistances {
public:
    using Outside = std::array<std::vector<Real>, static_cast<std::size_t>(dim)>;
    /// @param targets the particles whose neighbours are listed, and @param sources those in the lists
    /// @param outside how far each target was outside the periodic box at the search, m, by direction and target; null
    /// if all were inside
    PairDistances(const search::RunList& runs, const search::Points<dim, Real>& targets,
                  const search::Points<dim, Real>& sources, const search::Periodic<dim>& periodic,
                  const Outside* outside)
        : runs_(runs), targets_(targets), sources_(sources), periodic_(periodic), outside_(outside) {}

    /// The distance of the nearest pair, m; infinite if there is none.
    double nearest(int threads) const {
        return std::sqrt(parallel_reduce(
            targets_.n, threads, std::numeric_limits<double>::infinity(),
            [&](int begin, int end) {
                using T = Pack<Real, width>;
                T least2(std::numeric_limits<Real>::infinity());
                for (int i = begin; i < end; ++i)
                    runs_[i].for_each([&](search::Run run, int image) {
                        T distance2(0);
                        for (int d = 0; d < dim; ++d)
                            distance2 += sq(T(place_for(image, i, d)) -
                                            T::load(sources_.x[static_cast<std::size_t>(d)] + run.first()));
                        least2 = min(least2, select_first(static_cast<unsigned>(run.count()), distance2, least2));
                    });
                double nearest2 = std::numeric_limits<double>::infinity();
                for (int k = 0; k < T::size; ++k)
                    nearest2 = std::min(nearest2, static_cast<double>(least2[k]));
                return nearest2;
            },
            [](double one, double other) { return std::min(one, other); }));
    }

    /// The source nearest to target i, and its distance, m; -1 and infinite if it has no neighbour.
    std::pair<int, double> nearest_of(int i) const {
        int nearest = -1;
        double least2 = std::numeric_limits<double>::infinity();
        for_each(i, [&](int j, double distance2) {
            if (distance2 < least2) {
                nearest = j;
                least2 = distance2;
            }
        });
        return {nearest, std::sqrt(least2)};
    }
    /// The median distance of the nearest other particle over a sample, m, of those that have one within reach; 0 if
    /// none has. For a phase with itself.
    double median_nearest() const {
        std::vector<double> nearest;
        const int stride = std::max(1, targets_.n / 1000);
        for (int i = 0; i < targets_.n && !runs_.is_empty(); i += stride) {
            double least2 = std::numeric_limits<double>::infinity();
            for_each(i, [&](int, double distance2) { least2 = distance2 > 0 ? std::min(least2, distance2) : least2; });
            if (std::isfinite(least2))
                nearest.push_back(std::sqrt(least2));
        }
        if (nearest.empty())
            return 0;
        const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
        std::nth_element(nearest.begin(), middle, nearest.end());
        return *middle;
    }
    /// The mean number of neighbours nearer than `support`, m, without the particle itself, over a sample.
    double mean_number(double support) const {
        if (targets_.n == 0 || runs_.is_empty())
            return 0;
        const int stride = std::max(1, targets_.n / 1000);
        long long found = 0, sampled = 0;
        for (int i = 0; i < targets_.n; i += stride, ++sampled)
            for_each(i, [&](int, double distance2) { found += distance2 > 0 && distance2 < support * support; });
        return static_cast<double>(found) / static_cast<double>(sampled);
    }

    /// The share of the surroundings of target i that the sources fill, each with the volume spacing^dim: sum_b V_b
    /// W(|x_i - x_b|) with Wendland's C2 over `support`, m. A half at a plane face.
    double filled_around(int i, double support, double spacing) const {
        const double peak = WendlandC2::normalisation<dim>() * power<dim>(spacing / support);
        double share = 0;
        for_each(i, [&](int, double distance2) { share += peak * WendlandC2::value(std::sqrt(distance2) / support); });
        return share;
    }
    /// Has target i no neighbours? Costs nothing.
    bool is_alone(int i) const { return runs_[i].is_empty(); }

private:
    const search::RunList& runs_;
    search::Points<dim, Real> targets_, sources_;
    const search::Periodic<dim>& periodic_;
    const Outside* outside_;

    // Calls f(source, distance^2) for every source in the runs of target i.
    template <class F>
    void for_each(int i, const F& f) const {
        runs_[i].for_each([&](search::Run run, int image) {
            for (std::size_t j = run.first(); j < run.first() + run.count(); ++j) {
                double distance2 = 0;
                for (int d = 0; d < dim; ++d)
                    distance2 += sq(static_cast<double>(place_for(image, i, d)) -
                                    static_cast<double>(sources_.x[static_cast<std::size_t>(d)][j]));
                f(static_cast<int>(j), distance2);
            }
        });
    }
    // Coordinate d of target i as seen from an image of the domain.
    IMBIBE_INLINE Real place_for(int image, int i, int d) const {
        const auto k = static_cast<std::size_t>(d);
        const Real length = static_cast<Real>(periodic_.length[k]), here = targets_.x[k][i];
        if (length == 0)
            return here;
        const Real at = outside_ != nullptr ? here - (*outside_)[k][static_cast<std::size_t>(i)] : here;
        return at - static_cast<Real>(search::image_step(image, d)) * length;
    }
};

} // namespace imbibe::detail
