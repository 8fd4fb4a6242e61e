// How long steps can be, and how far a scene can be pushed, before it goes wrong: a matrix of compositions and hard
// cases, each bisected. Writes the tables of docs/stability_tables.md between their markers.
//
//   build-benchmark/studies/stability --write docs/stability_tables.md       half an hour on one core
//   build-benchmark/studies/stability --composition paper --scene splash --cfl 0.4 --trace       one run, looked at
//   build-benchmark/studies/stability --part Limits                   a part of the tables, printed
#include <cases/stability/rows.hpp>
#include <cases/support/document.hpp>
#include <cases/support/largest_stable.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <optional>
#include <sstream>

namespace {

using namespace stability;

std::string number(double x) {
    char words[32];
    std::snprintf(words, sizeof words, "%.2g", x);
    return words;
}
std::string signs_of(const Outcome& out) {
    std::string all;
    for (const Sign& sign : out.signs)
        all += (all.empty() ? "" : "; ") + sign.name + " " + number(sign.worst) + " (" + number(sign.bound) + ")";
    return all;
}

std::string drift_of(const Outcome& out) {
    return std::isnan(out.energy_drift) ? "not known" : number(out.energy_drift);
}

struct Bisected {
    double largest;
    Outcome usual, beyond; // at a CFL number of 0.4, and at the least one that fails
};

Bisected bisect(const Row& row, double highest) {
    Bisected result{0, row.run({.cfl = 0.4, .value = row.value, .ask = true}), {}};
    result.largest = sph::bench::largest_stable(0.2, 1, highest, [&](double cfl) {
        Outcome out = row.run({.cfl = cfl, .value = row.value});
        if (!out.stable)
            result.beyond = out;
        return out.stable;
    });
    return result;
}

std::string largest_words(double largest, double highest) {
    return largest == 0 ? "none" : largest >= highest ? "above " + number(highest) : number(largest);
}

/// The bisection takes it that shorter steps do no worse; where the default step says otherwise, that is said.
std::string largest_words(const Bisected& cell, double highest) {
    return largest_words(cell.largest, highest) + (cell.largest > 0.4 && !cell.usual.stable ? ", but not 0.4" : "");
}

/// Rows of one part, as a matrix of compositions and scenes and a list of what was seen.
void write_part(std::ostream& out, const std::string& part, const std::vector<Row>& rows, double highest) {
    std::vector<std::string> compositions, scenes;
    std::map<std::pair<std::string, std::string>, Bisected> cells;
    const auto note = [](std::vector<std::string>& list, const std::string& name) {
        if (std::find(list.begin(), list.end(), name) == list.end())
            list.push_back(name);
    };
    for (const Row& row : rows) {
        note(compositions, row.composition);
        note(scenes, row.scene);
        const auto start = std::chrono::steady_clock::now();
        const Bisected cell = bisect(row, highest);
        cells[{row.composition, row.scene}] = cell;
        std::fprintf(stderr, "%s: %s, %s: %s (%.1f s)\n", part.c_str(), row.composition.c_str(), row.scene.c_str(),
                     largest_words(cell.largest, highest).c_str(),
                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    out << "\n## " << part << "\n\n";
    if (part != "Limits") {
        out << "| largest stable CFL number |";
        for (const auto& scene : scenes)
            out << ' ' << scene << " |";
        out << "\n|---|";
        for (std::size_t k = 0; k < scenes.size(); ++k)
            out << "---|";
        for (const auto& composition : compositions) {
            out << "\n| " << composition << " |";
            for (const auto& scene : scenes) {
                const auto cell = cells.find({composition, scene});
                out << ' ' << (cell == cells.end() ? "" : largest_words(cell->second, highest)) << " |";
            }
        }
        out << "\n\n";
    }
    const bool asked = std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
        return cells[{row.composition, row.scene}].usual.asked > 0;
    });
    out << "| composition | scene | limited by | largest stable CFL number |" << (asked ? " asked |" : "")
        << " what fails beyond | indicators at 0.4 (bound) | energy drift at 0.4 |\n|---|---|---|---|"
        << (asked ? "---|" : "") << "---|---|---|\n";
    for (const Row& row : rows) {
        const Bisected& cell = cells[{row.composition, row.scene}];
        out << "| " << row.composition << " | " << row.scene << " | " << cell.usual.limit << " | "
            << largest_words(cell, highest) << " | "
            << (!asked                 ? ""
                : cell.usual.asked > 0 ? number(cell.usual.asked) + " | "
                                       : " | ")
            << cell.beyond.cause << " | " << signs_of(cell.usual) << " | " << drift_of(cell.usual) << " |\n";
    }
}

void write_frontiers(std::ostream& out, const std::vector<Frontier>& frontiers) {
    out << "\n## Physical limits at the CFL number 0.4\n\n"
           "| composition | scene | quantity | stable to | tried to | what fails beyond |\n|---|---|---|---|---|---|\n";
    for (const Frontier& f : frontiers) {
        Outcome beyond;
        const bool rising = f.harsh > f.mild;
        const auto value = [&](double x) { return rising ? f.mild * x : f.mild / x; };
        const double most = rising ? f.harsh / f.mild : f.mild / f.harsh;
        const double largest = sph::bench::largest_stable(1, 1, most, [&](double x) {
            const Outcome now = f.run({.cfl = 0.4, .value = value(x)});
            if (!now.stable)
                beyond = now;
            return now.stable;
        });
        const auto shown = [&](double x) {
            char words[32];
            std::snprintf(words, sizeof words, "%.4g", std::round(f.shown(value(x)) * 1e4) / 1e4);
            return std::string(words);
        };
        std::fprintf(stderr, "%s, %s: %s\n", f.composition.c_str(), f.scene.c_str(),
                     largest == 0 ? "none" : shown(largest).c_str());
        out << "| " << f.composition << " | " << f.scene << " | " << f.quantity << " | "
            << (largest == 0 ? "not even " + shown(1) : shown(largest)) << " | " << shown(most) << " | " << beyond.cause
            << " |\n";
    }
}

} // namespace

int main(int argc, char** argv) {
    std::string path, composition, scene, part;
    double cfl = 0, value = 0;
    bool trace = false;
    CLI::App app{"Bisects how long steps can be, and how far scenes can be pushed, before they go wrong."};
    app.add_option("--write", path, "the file whose tables are replaced; without it they are printed");
    app.add_option("--part", part, "Fluids, Solids, Coupled, Limits, Hard, Physical, Gradients or Frames only");
    app.add_option("--composition", composition, "only this one");
    app.add_option("--scene", scene, "only this one");
    app.add_option("--cfl", cfl, "one run with this CFL number instead of bisecting");
    CLI::Option* const pushed =
        app.add_option("--value", value, "with --cfl: what the scene is pushed by, in place of the table's");
    app.add_flag("--trace", trace, "print kinetic energy and indicators over time");
    CLI11_PARSE(app, argc, argv);

    if (!path.empty() && (!part.empty() || !composition.empty() || !scene.empty() || cfl > 0)) {
        std::fprintf(stderr, "stability: --write replaces all tables, so it goes with no choice of some of them\n");
        return 2;
    }
    if (pushed->count() > 0 && !(cfl > 0)) {
        std::fprintf(stderr, "stability: --value is for one run, so it goes with --cfl only\n");
        return 2;
    }
    Table table;
    add_fluids(table);
    add_solids(table);
    add_coupled(table);
    add_limits(table);
    add_hard(table);
    const auto wanted = [&](const auto& row) {
        return (composition.empty() || row.composition == composition) && (scene.empty() || row.scene == scene);
    };
    try {
        std::optional<sph::bench::Document> document;
        if (!path.empty())
            document.emplace(path, "studies/stability");
        if (cfl > 0) {
            for (const Row& row : table.rows)
                if (wanted(row) && (part.empty() || part == row.part)) {
                    const Outcome out =
                        row.run({.cfl = cfl, .value = pushed->count() > 0 ? value : row.value, .trace = trace});
                    std::printf("%s, %s: %s%s; %lld steps, limited by %s; %s; energy drift %s\n",
                                row.composition.c_str(), row.scene.c_str(),
                                out.stable ? "stable" : "failed: ", out.message.c_str(), out.steps, out.limit.c_str(),
                                signs_of(out).c_str(), drift_of(out).c_str());
                }
            return 0;
        }
        std::ostringstream out;
        for (const std::string name : {"Limits", "Fluids", "Solids", "Coupled", "Hard"}) {
            std::vector<Row> rows;
            std::copy_if(table.rows.begin(), table.rows.end(), std::back_inserter(rows),
                         [&](const Row& row) { return row.part == name && wanted(row); });
            if (!rows.empty() && (part.empty() || part == name))
                write_part(out, name, rows, 4);
        }
        if (part.empty() || part == "Physical") {
            std::vector<Frontier> frontiers;
            std::copy_if(table.frontiers.begin(), table.frontiers.end(), std::back_inserter(frontiers), wanted);
            if (!frontiers.empty())
                write_frontiers(out, frontiers);
        }
        if (composition.empty() && scene.empty() && (part.empty() || part == "Gradients"))
            write_gradients(out);
        if (composition.empty() && scene.empty() && (part.empty() || part == "Frames"))
            write_frames(out);
        if (document)
            document->replace(out.str());
        else
            std::cout << out.str();
    } catch (const sph::Error& error) {
        std::fprintf(stderr, "stability: %s\n", error.what());
        return 2;
    }
    return 0;
}
