// Checksums of all that a scene holds after some steps, to see that a change of the library changed no bit.
#pragma once

#include "poisoned.hpp"

#include <imbibe/output/checkpoint.hpp>
#include <imbibe/solver/solver.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace imbibe_test {

/// Checksums by what they are of: "phase field".
using Checksums = std::map<std::string, std::uint64_t>;

/// A 64-bit checksum (FNV-1a, Fowler, Noll and Vo) of some bytes, behind those that it is of already.
inline std::uint64_t checksum_of(const void* bytes, std::size_t count, std::uint64_t sum = 0xcbf29ce484222325ULL) {
    for (std::size_t k = 0; k < count; ++k)
        sum = (sum ^ static_cast<const unsigned char*>(bytes)[k]) * 0x100000001b3ULL;
    return sum;
}

/// Those of every column of every phase, particles in the order in which they were added; of the order in which they
/// lie in memory, by their numbers; and of the time.
template <class Scene>
Checksums checksums_of(const Scene& scene) {
    Checksums all;
    const double time = scene.time();
    all["time"] = checksum_of(&time, sizeof time);
    const auto add_phase = [&]<class P>(std::type_identity<P>) {
        const auto phase = scene.template get<P>();
        const std::string name = imbibe::detail::name_among<P>(typename Scene::Phases{});
        std::vector<std::pair<std::uint32_t, int>> order;
        for (int i = 0; i < phase.size(); ++i)
            order.emplace_back(phase.ids()[static_cast<std::size_t>(i)], i);
        std::sort(order.begin(), order.end());
        const auto add_field = [&]<class F>(F field) {
            const auto values = phase[field];
            std::uint64_t sum = checksum_of(nullptr, 0);
            for (int k = 0; k < static_cast<int>(values.cols()); ++k)
                for (const auto& [id, i] : order) {
                    const typename Scene::Real value = values(i, k) + 0; // -0 is 0
                    sum = checksum_of(&value, sizeof value, sum);
                }
            all[name + " " + std::string(F::name)] = sum;
        };
        [&]<class... F>(imbibe::TypeList<F...>) { (add_field(F{}), ...); }(typename Scene::template FieldsOf<P>{});
        all[name + " ids"] = checksum_of(phase.ids().data(), phase.ids().size() * sizeof(phase.ids()[0]));
    };
    [&]<class... P>(imbibe::TypeList<P...>) { (add_phase(std::type_identity<P>{}), ...); }(typename Scene::Phases{});
    return all;
}

/// Lets the loops of a scene run in a Poisoned space.
template <class Scene>
void poison(Scene& scene) {
    auto& engine = const_cast<typename Scene::Engine&>(scene.engine());
    engine.space = std::make_shared<Poisoned<Scene::dimension, typename Scene::Real>>();
}

/// All scenes that were run: their checksums by "scene phase field", and what was wrong with them.
struct Record {
    Checksums all;
    std::vector<std::string> faults;
    static constexpr int steps = 100; ///< how many each takes

    /// Runs what `make(threads)` makes with 1 and 2 threads, once more from a checkpoint after sixty steps, and where
    /// loops hold only the columns that they declare, and takes the checksums down under a name. They must be the same.
    template <class Make>
    void run(const std::string& name, const Make& make) {
        const auto path = std::filesystem::temp_directory_path() / imbibe::text("imbibe_bits_", getpid());
        const int before = 60;
        const auto march = [](auto& scene, int count) {
            for (int k = 0; k < count; ++k)
                scene.step();
        };
        const auto whole = [&](int threads, bool poisoned = false) {
            auto scene = make(threads);
            if (poisoned)
                poison(scene);
            march(scene, before);
            imbibe::write_checkpoint(scene, path);
            march(scene, steps - before);
            return checksums_of(scene);
        };
        const Checksums on_two = whole(2), on_one = whole(1);
        auto again = make(1);
        imbibe::read_checkpoint(again, path);
        march(again, steps - before);
        compare(name + ", 2 threads", on_two, on_one);
        compare(name + ", after a restart", checksums_of(again), on_one);
        compare(name + ", where loops hold what they declare", whole(1, true), on_one);
        for (const auto& [what, sum] : on_one)
            all[name + " " + what] = sum;
        std::filesystem::remove(path);
        std::filesystem::remove(path.string() + ".previous");
        std::fprintf(stderr, "%s: %zu columns\n", name.c_str(), on_one.size());
    }
    /// In double and in float: make(Real, threads).
    template <class Make>
    void run_both(const std::string& name, const Make& make) {
        run(name + " double", [&](int threads) { return make(double(), threads); });
        run(name + " float", [&](int threads) { return make(float(), threads); });
    }
    /// Takes down in which lines one differs from what is expected.
    void compare(const std::string& name, const Checksums& one, const Checksums& expected) {
        for (const auto& [what, sum] : expected)
            if (const auto found = one.find(what); found == one.end() || found->second != sum)
                faults.push_back(name + ": " + what);
        for (const auto& [what, sum] : one)
            if (!expected.contains(what))
                faults.push_back(name + ": " + what + " is new");
    }
};

void run_sponges(Record& record);
void run_water(Record& record);
void run_solids(Record& record);

} // namespace imbibe_test
