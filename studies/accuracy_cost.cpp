// What accuracy costs in time: scenes with a reference, run over spacings, schemes, kernels, supports, couplings, time
// steps and number types. Writes a table; tools/plot_accuracy.py draws it.
//
//   build-benchmark/studies/accuracy_cost taylor-green -o taylor-green.csv     vortices that decay, Re = 100
//   build-benchmark/studies/accuracy_cost poiseuille -o poiseuille.csv         the start of a flow between plates
//   build-benchmark/studies/accuracy_cost taylor-green --quick                 coarse spacings only
//   build-benchmark/studies/accuracy_cost poiseuille --axis "cfl=0.1;0.4" --axis "precision=float" --combine
//                                                      these choices in place of the case's, and all their combinations
//
// tools/accuracy_instructions.py adds the number of instructions of each run to such a table.
//
// The other cases: dam-break, cylinders, plate, soft-plate, sponge; one file each in accuracy/, whose first lines say
// what it is.
#include <cases/accuracy/cases.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>
#include <optional>
#include <sstream>

namespace {

/// Takes over "NAME=ONE;ANOTHER".
void replace(cost::accuracy::Study& study, const std::string& axis) {
    const auto equals = axis.find('=');
    imbibe::require(equals != std::string::npos, "--axis \"", axis,
                    "\": it must be a name, =, and choices with ; between them, as in --axis \"support=2;2.6\"");
    std::vector<std::string> choices;
    std::istringstream words(axis.substr(equals + 1));
    for (std::string word; std::getline(words, word, ';');)
        choices.push_back(word);
    study.instead(axis.substr(0, equals), choices);
}

/// The rest of a line.
void print(const cost::accuracy::Choices& choices) {
    for (const auto& [axis, value] : choices.all())
        std::printf("  %s %s", axis.c_str(), value.c_str());
    std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
    using cost::Rows;
    const std::map<std::string, Rows (*)(cost::accuracy::Study, bool)> cases{
        {"taylor-green", cost::taylor_green}, {"poiseuille", cost::poiseuille},
        {"dam-break", cost::dam_break},       {"cylinders", cost::cylinders},
        {"plate", cost::plate},               {"soft-plate", cost::soft_plate},
        {"sponge", cost::sponge}};
    std::string name, output = "accuracy.csv";
    std::vector<std::string> axes;
    bool quick = false, combine = false;
    std::optional<std::size_t> row_alone;
    std::optional<int> repetitions;
    CLI::App app{"What accuracy costs in time: a scene with a reference over spacings, schemes, supports and steps."};
    std::vector<std::string> names;
    for (const auto& [known, run] : cases)
        names.push_back(known);
    app.add_option("case", name, "which scene")->required()->check(CLI::IsMember(names));
    app.add_option("-o,--output", output, "the table to write")->capture_default_str();
    app.add_flag("--quick", quick, "the coarsest spacings only");
    app.add_option("--axis", axes, "choices in place of those of the case: \"NAME=ONE;ANOTHER\"; once for each axis")
        ->allow_extra_args(false);
    app.add_flag("--combine", combine, "every combination, not one choice at a time");
    app.add_option("--repeat", repetitions,
                   "runs of each choice, in taylor-green, poiseuille, dam-break and cylinders, whose starts "
                   "are jittered then: the error bars")
        ->check(CLI::Range(1, 1000));
    app.add_option("--row", row_alone, "this row of the table alone, counted from 0, without repetitions");
    CLI11_PARSE(app, argc, argv);

    cost::accuracy::Study study;
    if (row_alone)
        study.only(*row_alone);
    if (combine)
        study.combine();
    if (repetitions)
        study.repeat_instead(*repetitions);
    study.progress([](const cost::accuracy::Choices& choices, std::size_t done, std::size_t of) {
        std::printf("%3zu of %zu:", done + 1, of);
        print(choices);
        std::fflush(stdout);
    });
    Rows rows;
    try {
        for (const std::string& axis : axes)
            replace(study, axis);
        rows = cases.at(name)(study, quick);
        cost::accuracy::write(rows, output);
    } catch (const imbibe::Error& error) {
        std::fprintf(stderr, "accuracy_cost: %s\n", error.what());
        return 2;
    }
    for (const auto& row : rows) {
        if (!row.on_front && row.failure.empty())
            continue;
        if (row.on_front)
            std::printf("on the front: %8.2f s, error %.4f:", row.seconds, row.error);
        else
            std::printf("no result, %s:", row.failure.c_str());
        print(row.choices);
    }
    return 0;
}
