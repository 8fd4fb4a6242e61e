// Neighbour search on its own, without phases, terms or a solver: for other codes, and for looking at particles.
//
//   imbibe::search::NeighbourSearch<3, double> search(0.1);          // everything nearer than 0.1 m
//   const int water = search.add(x);                                 // x: n rows, 3 columns
//   search.update();
//   search.for_each(water, 17, [](int j, auto offset, double distance) { ... });
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/search/neighbours.hpp>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace imbibe::search {

/// Finds all pairs of points nearer to each other than a support radius, in any number of point sets.
///
/// After points are added or moved, `update` makes the search ready again, in O(n): a counting sort into cells. Memory
/// is bounded for any extent, the number of neighbours is not limited, and with periodic sides a neighbour is found in
/// every image within the support: once, if the period is at least twice the support. Several threads may call const
/// members at the same time.
///
/// The neighbours of a point come in the order of the cells, not of their numbers, with those seen through periodic
/// images last. The order is the same for any number of threads.
/// @tparam dim 2 or 3
/// @tparam Real float or double: of the coordinates, and of the comparison
template <int dim, class Real>
class IMBIBE_PER_BUILD NeighbourSearch {
public:
    /// n rows, one for each point, and dim columns; views of a scene's positions fit without a copy.
    using Positions =
        Eigen::Ref<const Eigen::Matrix<Real, Eigen::Dynamic, dim, Eigen::ColMajor>, 0, Eigen::OuterStride<>>;

    /// @param support the support radius, m, for all pairs of sets without their own (`set_support`)
    /// @param periodic lower ends and lengths of the periodic sides, m; each length must be at least the support
    /// @param threads at most 1024; 0: all of the machine
    /// @throws Error for a support that is not above 0, a period shorter than it, or too many threads
    explicit NeighbourSearch(double support, const Periodic<dim>& periodic = {}, int threads = 0)
        : support_(support), periodic_(periodic), threads_(threads > 0 ? threads : available_threads()) {
        check_support(support);
        require(threads <= most_threads, "threads = ", threads, "; it must be from 1 to ", most_threads,
                ", or 0 for all of the machine");
    }

    /// Adds a set of points. Returns its number: 0, 1, ...
    int add(const Positions& x) {
        sets_.push_back(std::make_unique<Set>());
        const int number = static_cast<int>(sets_.size()) - 1;
        move(number, x);
        return number;
    }
    /// Moves the points of a set; their number may change. Call `update` afterwards.
    void move(int set, const Positions& x) {
        Set& s = at(set);
        const auto n = static_cast<std::size_t>(x.rows());
        s.n = static_cast<int>(n);
        for (int d = 0; d < dim; ++d) {
            auto& column = s.given[static_cast<std::size_t>(d)];
            column.resize(n);
            Eigen::Map<Eigen::Matrix<Real, Eigen::Dynamic, 1>>(column.data(), x.rows()) = x.col(d);
        }
        ready_ = false;
    }
    /// Pairs between sets a and b (in both directions) are those nearer than `support`, m; 0: none at all, at no cost.
    void set_support(int a, int b, double support) {
        at(a), at(b);
        if (support != 0)
            check_support(support);
        std::erase_if(own_, [&](const Own& own) { return own.between(a, b); });
        own_.push_back({a, b, support});
        ready_ = false;
    }

    /// Makes the search ready after points were added or moved.
    /// @throws Error for a coordinate that is not a finite number, and for a set of more than 268 million points
    void update() {
        Bounds<dim> all;
        long long points = 0;
        double greatest = 0;
        for (std::size_t k = 0; k < sets_.size(); ++k) {
            Set& s = *sets_[k];
            for (int d = 0; d < dim; ++d) {
                auto& sorted = s.sorted[static_cast<std::size_t>(d)];
                sorted = s.given[static_cast<std::size_t>(d)];
                wrap(sorted, d);
                sorted.resize(static_cast<std::size_t>(s.n) + read_beyond);
            }
            if (s.n == 0)
                continue;
            const Bounds<dim> bounds = bounds_of(s.points(), threads_);
            if (bounds.not_finite >= 0)
                throw_not_finite(s, k, static_cast<std::size_t>(bounds.not_finite));
            all.include(bounds);
            points += s.n;
            for (std::size_t other = 0; other < sets_.size(); ++other)
                greatest = std::max(greatest, support_of(static_cast<int>(k), static_cast<int>(other)));
        }
        if (points > 0 && greatest > 0) {
            grid_.fit(all, greatest, periodic_, points);
            for (auto& s : sets_)
                s->sort(grid_, threads_);
        }
        lists_.assign(sets_.size() * sets_.size(), {});
        for (int a = 0; a < set_count(); ++a)
            for (int b = 0; b < set_count(); ++b)
                find(a, b);
        ready_ = true;
    }

    /// How many sets there are.
    int set_count() const { return static_cast<int>(sets_.size()); }
    /// How many points a set has.
    int size(int set) const { return at(set).n; }
    /// The support radius between two sets, m.
    double support_of(int a, int b) const {
        for (const Own& own : own_)
            if (own.between(a, b))
                return own.support;
        return support_;
    }

    /// Calls f(j, offset, distance) for every point j of set b nearer to point i of set a than their support; `offset`
    /// is the vector to i from j, or from the image of j, m. Within one set the point itself is left out, other
    /// points in the same place are not.
    template <class F>
    void for_each(int a, int i, int b, const F& f) const {
        require(ready_, "call update() after points were added or moved, before asking for neighbours");
        const Set &targets = at(a), &sources = at(b);
        require(i >= 0 && i < targets.n, "point ", i, " of set ", a, "; it must be from 0 to ", targets.n - 1);
        const Real support = static_cast<Real>(support_of(a, b)), support2 = support * support;
        if (support == 0)
            return;
        const auto rank = targets.rank[static_cast<std::size_t>(i)];
        lists_[list_number(a, b)][static_cast<int>(rank)].for_each([&](Run run, int image) {
            for (std::size_t k = run.first(); k < run.first() + run.count(); ++k) {
                Eigen::Matrix<Real, dim, 1> offset;
                for (int d = 0; d < dim; ++d) {
                    const auto axis = static_cast<std::size_t>(d);
                    const Real shift = static_cast<Real>(image_step(image, d) * periodic_.length[axis]);
                    offset[d] = targets.sorted[axis][rank] - shift - sources.sorted[axis][k];
                }
                const Real distance2 = offset.squaredNorm();
                const int j = static_cast<int>(sources.number[k]);
                if (distance2 < support2 && !(a == b && i == j))
                    f(j, offset, std::sqrt(distance2));
            }
        });
    }
    /// The same within one set.
    template <class F>
    void for_each(int set, int i, const F& f) const {
        for_each(set, i, set, f);
    }
    /// The number of neighbours of point i of set a in set b.
    int count(int a, int i, int b) const {
        int n = 0;
        for_each(a, i, b, [&](int, const auto&, Real) { ++n; });
        return n;
    }
    /// The number of neighbours of point i in its own set.
    int count(int set, int i) const { return count(set, i, set); }

private:
    struct Set {
        using Columns = std::array<std::vector<Real>, static_cast<std::size_t>(dim)>;
        int n = 0;
        Columns given, sorted;
        std::vector<std::uint32_t> number, rank; // of the point at a place in the order; of a point, its place there
        CellTable table;

        Points<dim, Real> points() const {
            Points<dim, Real> p;
            p.n = n;
            for (std::size_t d = 0; d < dim; ++d)
                p.x[d] = sorted[d].data();
            return p;
        }
        void sort(const Grid<dim>& grid, int threads) {
            const auto size = static_cast<std::size_t>(n);
            number.resize(size);
            rank.resize(size);
            for (std::size_t k = 0; k < size; ++k)
                number[k] = static_cast<std::uint32_t>(k);
            if (!table.sort(grid, points(), threads)) {
                number = table.order();
                Columns moved = sorted;
                for (std::size_t d = 0; d < dim; ++d)
                    for (std::size_t k = 0; k < size; ++k)
                        moved[d][k] = sorted[d][number[k]];
                sorted.swap(moved);
            }
            for (std::size_t k = 0; k < size; ++k)
                rank[number[k]] = static_cast<std::uint32_t>(k);
        }
    };
    struct Own {
        int a, b;
        double support;

        bool between(int x, int y) const { return (a == x && b == y) || (a == y && b == x); }
    };

    double support_;
    Periodic<dim> periodic_;
    int threads_;
    bool ready_ = false;
    std::vector<std::unique_ptr<Set>> sets_;
    std::vector<Own> own_;
    std::vector<RunList> lists_; // of each set in each
    Grid<dim> grid_;

    const Set& at(int set) const {
        require(set >= 0 && set < set_count(), "set ", set, "; it must be from 0 to ", set_count() - 1,
                ", as `add` returned it");
        return *sets_[static_cast<std::size_t>(set)];
    }
    Set& at(int set) { return const_cast<Set&>(std::as_const(*this).at(set)); }
    std::size_t list_number(int a, int b) const {
        return static_cast<std::size_t>(a) * sets_.size() + static_cast<std::size_t>(b);
    }
    void check_support(double support) const {
        require(std::isfinite(support) && support > 0, "support = ", support,
                " m; it must be a finite number above 0 m");
        for (double lower : periodic_.lower)
            require(std::isfinite(lower), "a periodic side that begins at ", lower, " m; that must be a finite number");
        for (double length : periodic_.length)
            require(std::isfinite(length) && (length == 0 || length >= support), "a period of ", length,
                    " m; it must be 0 (not periodic) or a finite number not below the support, ", support, " m");
    }
    [[noreturn]] void throw_not_finite(const Set& s, std::size_t set, std::size_t point) const {
        std::size_t d = 0;
        while (d + 1 < dim && std::abs(s.given[d][point]) < Real(1e30))
            ++d;
        throw Error(text("coordinate ", d, " of point ", point, " of set ", set, " is ", s.given[d][point],
                         " m; coordinates must be finite numbers between -1e30 and 1e30 m"));
    }
    void wrap(std::vector<Real>& x, int d) const {
        const auto axis = static_cast<std::size_t>(d);
        if (periodic_.length[axis] > 0)
            for (Real& value : x)
                if (std::isfinite(value))
                    value = into_period(value, static_cast<Real>(periodic_.lower[axis]),
                                        static_cast<Real>(periodic_.length[axis]));
    }
    void find(int a, int b) {
        RunList& list = lists_[list_number(a, b)];
        const Set &targets = at(a), &sources = at(b);
        const double support = support_of(a, b);
        if (targets.n == 0 || sources.n == 0 || support == 0)
            list.clear_all(targets.n);
        else
            find_runs<native_width<Real>>(list, targets.points(), sources.points(), grid_, sources.table, support,
                                          threads_);
    }
};

} // namespace imbibe::search
