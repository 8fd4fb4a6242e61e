// The accuracy study: which runs it makes, what it measures, and which it puts on the front.
#include <catch_shim.hpp>

#include <imbibe/accuracy/study.hpp>
#include <imbibe/imbibe.hpp>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

namespace accuracy = imbibe::accuracy;
using imbibe_test::contains;

namespace {

/// Works the processor for about `seconds`.
double burn(double seconds) {
    const auto begin = std::clock();
    double x = 1;
    while (static_cast<double>(std::clock() - begin) < seconds * CLOCKS_PER_SEC)
        x = std::sqrt(x + 1);
    return x;
}

std::string words(const accuracy::Choices& choices) {
    std::string all;
    for (const auto& [axis, value] : choices.all())
        all += value + " ";
    return all;
}

} // namespace

TEST_CASE("A study makes every combination, or departs from the first one axis at a time", "[accuracy]") {
    accuracy::Study study;
    study.axis("n", {"1", "2"}).axis("kernel", {"a", "b", "c"}).axis("step", {"long", "short"});
    std::vector<std::string> seen;
    const auto note = [&](const accuracy::Choices& choices) -> accuracy::Outcome {
        seen.push_back(words(choices));
        return {1 / choices.number("n")};
    };
    CHECK(study.run(note).size() == 12);
    CHECK(seen.front() == "1 a long ");
    CHECK(seen.back() == "2 c short ");
    seen.clear();
    CHECK(study.one_at_a_time(note).size() == 5);
    CHECK(seen == std::vector<std::string>{"1 a long ", "2 a long ", "1 b long ", "1 c long ", "1 a short "});
    seen.clear();
    CHECK(study.one_at_a_time(note, {"n"}).size() == 8);
    CHECK(seen.size() == 8);
    CHECK(seen[1] == "2 a long ");
    CHECK(seen[7] == "2 a short ");
}

TEST_CASE("A study also departs on several axes where it is asked to", "[accuracy]") {
    const auto seen = [](accuracy::Study study) {
        study.axis("n", {"1", "2"}).axis("kernel", {"a", "b"}).axis("step", {"long", "short"});
        std::vector<std::string> all;
        study.one_at_a_time(
            [&](const accuracy::Choices& choices) -> accuracy::Outcome {
                all.push_back(words(choices));
                return {0};
            },
            {"n"});
        return all;
    };
    accuracy::Study study;
    study.also({{"kernel", "b"}, {"step", "short"}}).also({{"kernel", "b"}}); // the second is there already
    CHECK(seen(study) == std::vector<std::string>{"1 a long ", "2 a long ", "1 b long ", "2 b long ", "1 a short ",
                                                  "2 a short ", "1 b short ", "2 b short "});
    accuracy::Study without = study;
    CHECK(seen(without.instead("step", {"long"})) ==
          std::vector<std::string>{"1 a long ", "2 a long ", "1 b long ", "2 b long "});
    accuracy::Study misspelt = study;
    CHECK_THROWS_WITH(seen(misspelt.also({{"kernel", "bb"}})), contains("the axis 'kernel' has no choice 'bb'"));
    CHECK_THROWS_WITH(seen(study.also({{"kernal", "b"}})), contains("the case has no axis 'kernal'"));
}

TEST_CASE("A study measures error bars and time, keeps failures, and finds the front", "[accuracy]") {
    accuracy::Study study;
    study.axis("method", {"slow and good", "fast and bad", "slow and bad", "breaks"}).repeat(3);
    const auto rows = study.run([](const accuracy::Choices& choices) -> accuracy::Outcome {
        const std::string& method = choices["method"];
        if (method == "breaks")
            throw imbibe::Error("it \"broke\"");
        burn(method.substr(0, 4) == "slow" ? 0.06 : 0.02);
        return {(method.find("good") != std::string::npos ? 0.01 : 0.1) * (1 + 0.1 * choices.repetition), 100};
    });
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].error == Approx(0.011));
    CHECK(rows[0].least_error == Approx(0.01));
    CHECK(rows[0].greatest_error == Approx(0.012));
    CHECK(rows[0].pair_evaluations == 100);
    CHECK(rows[0].seconds > rows[1].seconds);
    CHECK(rows[0].on_front);
    CHECK(rows[1].on_front);
    CHECK_FALSE(rows[2].on_front);
    CHECK_FALSE(rows[3].on_front);
    CHECK(rows[3].failure == "it \"broke\"");
    CHECK(std::isinf(rows[3].error));

    const auto path = std::filesystem::temp_directory_path() / "imbibe_accuracy_study.csv";
    accuracy::write(rows, path);
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    CHECK(line == "\"method\",error,least error,greatest error,seconds [s],pair evaluations,front,failure");
    std::getline(file, line);
    CHECK(line.substr(0, 37) == "\"slow and good\",0.011,0.01,0.012,0.06");
    std::getline(file, line);
    std::getline(file, line);
    std::getline(file, line);
    CHECK_THAT(line, contains("\"breaks\",inf,inf,inf,") && contains(",0,\"it \"\"broke\"\"\""));
    std::filesystem::remove(path);
}

TEST_CASE("A study runs one of its rows alone, and that once", "[accuracy]") {
    accuracy::Study study;
    study.axis("n", {"1", "2"}).axis("kernel", {"a", "b"}).repeat(3).only(2);
    std::vector<std::string> seen;
    const auto rows = study.run([&](const accuracy::Choices& choices) -> accuracy::Outcome {
        seen.push_back(words(choices));
        return {choices.number("n")};
    });
    CHECK(seen == std::vector<std::string>{"2 a "});
    seen.clear();
    accuracy::Study often;
    often.repeat_instead(2).axis("n", {"1"}).repeat(5);
    often.run([&](const accuracy::Choices& choices) -> accuracy::Outcome {
        seen.push_back(words(choices) + std::to_string(choices.repetition));
        return {0.1 * choices.repetition};
    });
    CHECK(seen == std::vector<std::string>{"1 0", "1 1"});
    CHECK_THROWS_WITH(often.repeat_instead(0), contains("0 repetitions; it must be at least 1"));
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].error == 2);
    study.only(4);
    REQUIRE_THROWS_WITH(study.run([](const accuracy::Choices&) -> accuracy::Outcome { return {0}; }),
                        contains("row 4 alone was asked for; the study has 4"));
}

TEST_CASE("A program's user may choose for a study", "[accuracy]") {
    const auto seen = [](accuracy::Study study) {
        study.axis("n", {"1", "2"}).axis("kernel", {"a", "b", "c"});
        std::vector<std::string> all;
        study.one_at_a_time([&](const accuracy::Choices& choices) -> accuracy::Outcome {
            all.push_back(words(choices));
            return {0};
        });
        return all;
    };
    using All = std::vector<std::string>;
    CHECK(seen({}) == All{"1 a ", "2 a ", "1 b ", "1 c "});
    CHECK(seen(accuracy::Study{}.instead("n", {"5"})) == All{"5 a ", "5 b ", "5 c "});
    CHECK(seen(accuracy::Study{}.instead("kernel", {"c", "a"}).combine()) == All{"1 c ", "1 a ", "2 c ", "2 a "});
    REQUIRE_THROWS_WITH(seen(accuracy::Study{}.instead("kernel", {"d"})),
                        contains("'kernel' has no choice 'd'; it has 'a', 'b', 'c'"));
    REQUIRE_THROWS_WITH(seen(accuracy::Study{}.instead("n", {"many"})), contains("takes numbers, as '1', '2'"));
    REQUIRE_THROWS_WITH(seen(accuracy::Study{}.instead("n", {"inf"})), contains("no choice 'inf'"));
    CHECK(seen(accuracy::Study{}.instead("kernel", {"b"}).instead("kernel", {"c"})) == All{"1 c ", "2 c "});
    accuracy::Study twice;
    twice.axis("kernel", {"a", "b", "c"}).instead("kernel", {"b"}).instead("kernel", {"c"}); // "c" is offered as before
    REQUIRE_THROWS_WITH(twice.one_at_a_time([](const accuracy::Choices&) -> accuracy::Outcome { return {0}; }, {"nn"}),
                        contains("no axis 'nn'; it has 'kernel'"));
    accuracy::Study late; // the axis was there first
    late.axis("kernel", {"a", "b"});
    REQUIRE_THROWS_WITH(late.instead("kernel", {"d"}), contains("no choice 'd'; it has 'a', 'b'"));
    All run;
    accuracy::Study{}.axis("kernel", {"a", "b"}).instead("kernel", {"b"}).run(
        [&](const accuracy::Choices& choices) -> accuracy::Outcome {
            run.push_back(words(choices));
            return {0};
        });
    CHECK(run == All{"b "});
    REQUIRE_THROWS_WITH(seen(accuracy::Study{}.instead("m", {"1"})), contains("no axis 'm'; it has 'n', 'kernel'"));
    REQUIRE_THROWS_WITH(accuracy::Study{}.instead("m", {}), contains("no choices are given for the axis 'm'"));
}

TEST_CASE("A study does not repeat what is always the same", "[accuracy]") {
    accuracy::Study study;
    study.axis("n", {"1", "2"});
    int runs = 0;
    const auto same = [&runs](const accuracy::Choices& choose) {
        ++runs;
        return accuracy::Outcome{0.1 / choose.number("n")};
    };
    CHECK(study.run(same).size() == 2);
    CHECK_THROWS_WITH(study.repeat(3).run(same), contains("the error is 0.1 in each of 3 repetitions"));
    CHECK(runs == 5); // noticed after the first choices
}

TEST_CASE("A study says what is wrong with it", "[accuracy]") {
    accuracy::Study study;
    study.axis("n", {"1", "two"});
    REQUIRE_THROWS_WITH(study.axis("n", {"3"}), contains("two axes 'n'"));
    REQUIRE_THROWS_WITH(study.axis("m", {}), contains("'m' has no choices"));
    REQUIRE_THROWS_WITH(study.repeat(0), contains("at least 1"));
    const auto rows = study.run([](const accuracy::Choices& choices) -> accuracy::Outcome {
        return {choices["n"] == "1" ? choices.number("k") : choices.number("n")};
    });
    CHECK_THAT(rows[0].failure, contains("asks for the axis 'k'"));
    CHECK_THAT(rows[1].failure, contains("'two' on the axis 'n' is not a number"));
}

TEST_CASE("The pairs of a scene are counted in all its sweeps", "[accuracy]") {
    using K = imbibe::WendlandC2;
    struct Gas : imbibe::Fluid<imbibe::LinearState, imbibe::Continuity<K>, imbibe::SymmetricPressure<K>> {};
    const auto pairs_after_three_steps = []<class Integrator>(Integrator) {
        imbibe::Solver<2, double, Integrator, Gas> scene({.support_radius = 0.15, .periodic_length = {1, 1}});
        scene.add(Gas{{.density = 1, .sound_speed = 1}}, imbibe::fill(imbibe::Box<2>({0, 0}, {1, 1}), 0.1), 0.1);
        for (int k = 0; k < 3; ++k)
            scene.step(1e-9);
        return accuracy::pair_evaluations(scene);
    };
    // steps, sweeps, particles, neighbours
    CHECK(pairs_after_three_steps(imbibe::SymplecticEuler{}) == Approx(3 * 2 * 100 * 8));
    // two evaluations a step, rates and forces of each in one sweep
    CHECK(pairs_after_three_steps(imbibe::MidpointRungeKutta{}) == Approx(3 * 2 * 1 * 100 * 8));
}
