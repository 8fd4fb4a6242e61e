// The cost of accuracy: runs a case with a reference over chosen axes and says which choices are worth their time.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/number_in_text.hpp>
#include <imbibe/output/file.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace imbibe::accuracy {

/// One choice on every axis of a study: the input of a case.
class Choices {
public:
    /// The choice on an axis, as it was written. Throws Error for an axis the study does not have.
    const std::string& operator[](const std::string& axis) const {
        for (const auto& [name, value] : values_)
            if (name == axis)
                return value;
        throw Error(text("accuracy: the case asks for the axis '", axis, "', which the study does not have"));
    }
    /// The same as a number. Throws Error if it is not one.
    double number(const std::string& axis) const {
        const std::string& word = (*this)[axis];
        const auto value = number_in(word);
        require(value.has_value(), "accuracy: '", word, "' on the axis '", axis, "' is not a number");
        return *value;
    }
    /// The finite number that a word is, if it is one.
    static std::optional<double> number_in(const std::string& word) {
        const auto found = detail::number_in_text(word);
        return found && found->is_all && std::isfinite(found->value) ? std::optional(found->value) : std::nullopt;
    }
    /// Which repetition this is, from 0 on: the seed of a jittered start.
    int repetition = 0;

    /// Sets the choice on an axis.
    void set(const std::string& axis, const std::string& value) {
        for (auto& [name, old] : values_)
            if (name == axis) {
                old = value;
                return;
            }
        values_.emplace_back(axis, value);
    }
    /// All choices, in the order of the axes: the name of an axis and the choice on it.
    const std::vector<std::pair<std::string, std::string>>& all() const { return values_; }

private:
    std::vector<std::pair<std::string, std::string>> values_;
};

/// The result of a case.
struct Outcome {
    double error;                ///< against the reference, in the case's own measure (such as a share); not negative
    double pair_evaluations = 0; ///< the work in a machine-independent unit; see `pair_evaluations(scene)`
};

/// One line of a study's result: a set of choices, over all repetitions.
struct Row {
    Choices choices;                           ///< the input of the case
    double error, least_error, greatest_error; ///< mean and range over the repetitions
    double seconds;                            ///< processor time of one repetition, the least of all
    double pair_evaluations;                   ///< of one repetition, see Outcome
    bool on_front = false; ///< is nothing else both faster and more accurate?
    std::string failure;   ///< why the run broke off, if it did; error is infinite then
};

/// An estimate of the pair evaluations of a scene so far, over all sweeps of all its steps and substeps, with the
/// present number of neighbours. Work before a restart is not counted.
template <class Scene>
double pair_evaluations(const Scene& scene) {
    double pairs = 0;
    const auto& engine = scene.engine();
    for (const auto& link : engine.links)
        pairs += engine.mean_neighbours(link) * engine.phase(link.row.a).size() * static_cast<double>(link.sweeps);
    return pairs;
}

/// Marks the rows of which no other is at least as fast and at least as accurate.
inline void mark_front(std::vector<Row>& rows) {
    for (Row& row : rows) {
        row.on_front = std::isfinite(row.error);
        for (const Row& other : rows)
            if (&other != &row && other.seconds <= row.seconds && other.error <= row.error &&
                (other.seconds < row.seconds || other.error < row.error))
                row.on_front = false;
    }
}

/// A case with a reference, run over chosen axes.
/// <!-- examples/guides/own_study.cpp -->
/// ```
/// accuracy::Study study;
/// study.axis("spacing", {"0.05", "0.025"})
///     .axis("kernel", {"Wendland C2", "cubic spline"})
///     .axis("support", {"2.6", "2", "3.2"});
/// const auto rows = study.run([](const accuracy::Choices& choose) {
///     return choose["kernel"] == "cubic spline" ? shear_wave<sph::CubicSpline>(choose)
///                                               : shear_wave<sph::WendlandC2>(choose);
/// });
/// accuracy::write(rows, "shear_wave.csv"); // python3 tools/plot_accuracy.py shear_wave.csv -o shear_wave.png
/// ```
/// `shear_wave` makes a scene from the choices, runs it, and returns an Outcome.
class Study {
public:
    /// Adds an axis with its choices; `one_at_a_time` departs from the first.
    /// @throws Error for an axis without choices, for an existing one, or, after `instead` for it, for a choice of
    /// `instead` that is not among the words, or not a number among numbers
    Study& axis(const std::string& name, const std::vector<std::string>& choices) {
        require(!choices.empty(), "accuracy: the axis '", name, "' has no choices");
        for (const auto& [known, values] : axes_)
            require(known != name, "accuracy: there are two axes '", name, "'");
        for (const auto& [replaced, others] : instead_)
            if (replaced == name)
                check_choices(name, choices, others);
        axes_.emplace_back(name, choices);
        return *this;
    }
    /// Replaces the choices of this axis, whether it was added already or will be, and those of an earlier `instead`:
    /// for a program whose user chooses. A run throws Error if the axis was never added.
    /// @throws Error for no choices, and for an existing axis as `axis` does
    Study& instead(const std::string& name, const std::vector<std::string>& choices) {
        require(!choices.empty(), "accuracy: no choices are given for the axis '", name, "'");
        for (const auto& [known, values] : axes_)
            if (known == name)
                check_choices(name, values, choices);
        instead_.emplace_back(name, choices);
        return *this;
    }
    /// `one_at_a_time` also runs this combination, which departs on several axes: an axis and the choice on it, for
    /// each. Left out if `instead` removes one of these choices, if it is there already, and with `combine`, which
    /// includes it. A run throws Error if one of the axes, or a choice of words on it, was never added.
    Study& also(const std::vector<std::pair<std::string, std::string>>& departures) {
        also_.push_back(departures);
        return *this;
    }
    /// Lets `one_at_a_time` run every combination, as `run` does.
    Study& combine() {
        combined_ = true;
        return *this;
    }
    /// Runs every choice this many times, each with another `Choices::repetition`, from which a case jitters its start:
    /// the error bars. A run throws Error if the first choices give exactly the same error each time: the case then
    /// ignores the repetition, and the bars would have no length.
    Study& repeat(int times) {
        repetitions_ = repetitions(times);
        return *this;
    }
    /// The number of repetitions in place of that of `repeat`, before or after: for a program whose user chooses.
    Study& repeat_instead(int times) {
        repetitions_instead_ = repetitions(times);
        return *this;
    }
    /// Runs only the row of this number, counted from 0, once: for measuring single runs from outside
    /// (tools/accuracy_instructions.py). A run throws Error if the study has no such row.
    Study& only(std::size_t row) {
        only_ = row;
        return *this;
    }
    /// Called before every set of choices is run, with the number done and the total.
    Study& progress(std::function<void(const Choices&, std::size_t, std::size_t)> tell) {
        tell_ = std::move(tell);
        return *this;
    }
    /// Every combination of all choices.
    template <class Case>
    std::vector<Row> run(const Case& what) const {
        std::vector<Choices> all{Choices{}};
        for (const auto& [name, values] : chosen())
            all = with_each(all, name, values);
        return run_all(all, what);
    }
    /// The first choice of every axis, all that differ from it on one axis, and the combinations of `also`. `along`:
    /// all choices on these axes are combined with each of them (the spacing, usually). Throws Error if one of these is
    /// no axis of the study.
    template <class Case>
    std::vector<Row> one_at_a_time(const Case& what, const std::vector<std::string>& along = {}) const {
        for (const std::string& name : along)
            require_axis(name);
        if (combined_)
            return run(what);
        const auto is_along = [&](const std::string& name) {
            return std::find(along.begin(), along.end(), name) != along.end();
        };
        const Axes axes = chosen();
        Choices first;
        for (const auto& [name, values] : axes)
            first.set(name, values.front());
        std::vector<Choices> all{first};
        for (const auto& [name, values] : axes)
            for (std::size_t k = 1; k < values.size() && !is_along(name); ++k) {
                all.push_back(first);
                all.back().set(name, values[k]);
            }
        add_also(all, first, axes);
        for (const auto& [name, values] : axes)
            if (is_along(name))
                all = with_each(all, name, values);
        return run_all(all, what);
    }

private:
    using Axes = std::vector<std::pair<std::string, std::vector<std::string>>>;
    Axes axes_, instead_; // as added, and their replacements
    std::vector<std::vector<std::pair<std::string, std::string>>> also_;
    bool combined_ = false;
    int repetitions_ = 1;
    std::optional<int> repetitions_instead_;
    std::optional<std::size_t> only_;
    std::function<void(const Choices&, std::size_t, std::size_t)> tell_;

    static int repetitions(int times) {
        require(times >= 1, "accuracy: ", times, " repetitions; it must be at least 1");
        return times;
    }
    int times() const { return only_ ? 1 : repetitions_instead_.value_or(repetitions_); }
    Axes chosen() const {
        Axes all = axes_;
        for (const auto& [replaced, others] : instead_)
            for (auto& [name, values] : all)
                if (name == replaced)
                    values = others;
        return all;
    }
    static void check_choices(const std::string& axis, const std::vector<std::string>& known,
                              const std::vector<std::string>& wanted) {
        const bool numbers = Choices::number_in(known.front()).has_value();
        for (const std::string& one : wanted)
            require(numbers ? Choices::number_in(one).has_value()
                            : std::find(known.begin(), known.end(), one) != known.end(),
                    "accuracy: the axis '", axis, "' has no choice '", one, "'; ",
                    numbers ? "it takes numbers, as " : "it has ", listed(known));
    }
    void require_axis(const std::string& wanted) const {
        std::vector<std::string> known;
        for (const auto& [name, choices] : axes_)
            known.push_back(name);
        require(std::find(known.begin(), known.end(), wanted) != known.end(), "accuracy: the case has no axis '",
                wanted, "'; it has ", listed(known));
    }
    static std::string listed(const std::vector<std::string>& words) {
        std::string all;
        for (const std::string& word : words)
            all += (all.empty() ? "'" : ", '") + word + "'";
        return all;
    }
    void add_also(std::vector<Choices>& all, const Choices& first, const Axes& axes) const {
        for (const auto& departures : also_) {
            Choices one = first;
            bool is_chosen = true;
            for (const auto& [name, value] : departures) {
                require_axis(name);
                for (const auto& [axis, values] : axes_)
                    if (axis == name)
                        check_choices(name, values, {value});
                one.set(name, value);
                for (const auto& [axis, values] : axes)
                    is_chosen &= axis != name || std::find(values.begin(), values.end(), value) != values.end();
            }
            is_chosen &= std::none_of(all.begin(), all.end(), [&](const Choices& o) { return o.all() == one.all(); });
            if (is_chosen)
                all.push_back(one);
        }
    }
    // Each of `all` with each value of an axis.
    static std::vector<Choices> with_each(const std::vector<Choices>& all, const std::string& axis,
                                          const std::vector<std::string>& values) {
        std::vector<Choices> longer;
        for (const Choices& one : all)
            for (const std::string& value : values) {
                longer.push_back(one);
                longer.back().set(axis, value);
            }
        return longer;
    }
    template <class Case>
    std::vector<Row> run_all(const std::vector<Choices>& all, const Case& what) const {
        for (const auto& [name, choices] : instead_)
            require_axis(name);
        require(!only_ || *only_ < all.size(), "accuracy: row ", only_.value_or(0), " alone was asked for; the study has ",
                all.size(), ", counted from 0");
        std::vector<Row> rows;
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (only_ && k != *only_)
                continue;
            if (tell_)
                tell_(all[k], k, all.size());
            rows.push_back(measure(all[k], what));
            const Row& row = rows.back();
            require(rows.size() > 1 || times() == 1 || row.least_error < row.greatest_error || !row.failure.empty(),
                    "accuracy: the error is ", row.error, " in each of ", times(),
                    " repetitions: the case does not jitter its start by Choices::repetition, so there are no error "
                    "bars; run it without repetitions");
        }
        mark_front(rows);
        return rows;
    }
    template <class Case>
    static Outcome outcome_of(const Case& what, const Choices& choices, std::string& failure) {
        try {
            const Outcome outcome = what(choices);
            require(outcome.error >= 0, "the error is ", outcome.error, "; a case must give one that is not negative");
            return outcome;
        } catch (const Error& error) {
            failure = error.what();
            return {std::numeric_limits<double>::infinity()};
        }
    }
    template <class Case>
    Row measure(const Choices& choices, const Case& what) const {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        Row row{choices, 0, infinity, 0, infinity, 0, false, {}};
        for (int k = 0; k < times(); ++k) {
            Choices mine = choices;
            mine.repetition = k;
            const std::clock_t begin = std::clock(); // of the processor: other programs do not count
            const Outcome outcome = outcome_of(what, mine, row.failure);
            row.seconds = std::min(row.seconds, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
            row.error += outcome.error / times();
            row.least_error = std::min(row.least_error, outcome.error);
            row.greatest_error = std::max(row.greatest_error, outcome.error);
            row.pair_evaluations = std::max(row.pair_evaluations, outcome.pair_evaluations);
        }
        return row;
    }
};

/// Writes rows as CSV: a column for each axis, then error, least and greatest error, seconds, pair evaluations, front
/// (1 or 0), failure. Words are in quotation marks, with their own doubled.
inline void write(const std::vector<Row>& rows, const std::filesystem::path& path) {
    const auto quoted = [](const std::string& words) {
        std::string all = "\"";
        for (const char c : words)
            all += c == '"' ? std::string("\"\"") : std::string(1, c);
        return all + "\"";
    };
    AtomicFile file(path);
    std::string line;
    if (!rows.empty())
        for (const auto& [axis, value] : rows.front().choices.all())
            line += quoted(axis) + ",";
    file << line + "error,least error,greatest error,seconds [s],pair evaluations,front,failure\n";
    for (const Row& row : rows) {
        line.clear();
        for (const auto& [axis, value] : row.choices.all())
            line += quoted(value) + ",";
        for (const double x : {row.error, row.least_error, row.greatest_error, row.seconds, row.pair_evaluations})
            line += text(x) + ",";
        file << line + (row.on_front ? "1" : "0") + "," + quoted(row.failure) + "\n";
    }
    file.commit();
}

} // namespace imbibe::accuracy
