// What a coupling costs while its phases are out of each other's reach: a strip of the sponge under 5 mm of water, a
// whole step with its search, float, one thread. The sponge alone, water and vessel alone, the same with the vessel's
// walls once more where no water is, all of them with the water still above the sponge's reach, and with the water on
// the sponge; the last also with a guard, which looks at all particles in one of ten steps. For callgrind, as
// count_instructions.cpp:
//
//   python3 tools/count_instructions.py build-benchmark/benchmarks/out_of_reach -o out_of_reach.json
//   build-benchmark/benchmarks/out_of_reach             the cases
//   build-benchmark/benchmarks/out_of_reach CASE        does the work of a case once; its items are steps
//   build-benchmark/benchmarks/out_of_reach --time CASE        prints the time of it, us per step
#include "support/measured.hpp"

#include <imbibe/monitor/guard.hpp>
#include <imbibe/presets/sponge.hpp>

#include <map>
#include <string>

namespace {

using namespace imbibe;
using Preset = presets::SoundSponge;
using Water = Preset::Water;
using Sponge = Preset::Sponge;
using Vessel = Preset::Vessel;
using Contact = Preset::Contact; // water and sponge
using Walls = Preset::Sides;     // water and vessel

presets::SpongeCase strip(double gap) {
    return {.water_spacing = 0.7e-3, .gap = gap, .search_interval = 1, .strip = true, .pool = 5e-3, .threads = 1};
}
/// Of the preset's scene the phases and couplings listed, all of which take the same steps.
/// @param twice does it have the vessel a second time, 10 cm above the first?
template <class... Items>
auto alone(double gap, bool twice = false) {
    const auto c = strip(gap);
    auto whole = Preset::make<float>(c);
    Solver<3, float, SymplecticEuler, Items...> scene(whole.settings());
    const auto copy = [&]<class P>(std::type_identity<P>, const std::vector<Point<3>>& points) {
        if constexpr ((std::is_same_v<P, Items> || ...)) {
            auto material = whole.template get<P>().material();
            const auto handle = scene.add(material, points, material.spacing);
            if constexpr (std::is_same_v<P, Sponge>)
                scene.hold(handle, [&](const Point<3>& x) { return c.clamped(x); });
        }
    };
    copy(std::type_identity<Water>{}, c.water());
    copy(std::type_identity<Sponge>{}, c.sponge());
    auto walls = c.vessel(whole.settings().support_radius);
    for (std::size_t k = 0, n = walls.size(); twice && k < n; ++k)
        walls.push_back(walls[k] + Point<3>(0, 0, 0.1));
    copy(std::type_identity<Vessel>{}, walls);
    if constexpr ((std::is_same_v<Walls, Items> || ...))
        scene.template coupling<Walls>() = whole.template coupling<Walls>();
    if constexpr ((std::is_same_v<Contact, Items> || ...))
        scene.template coupling<Contact>() = whole.template coupling<Contact>();
    return scene;
}
auto together(double gap) {
    return alone<Water, Sponge, Vessel, Contact, Walls>(gap);
}

constexpr double dry = 4.5e-3, wet = 0.4e-3; // m of air between water and sponge

constexpr int steps = 10; // as many as from one look of a guard to the next

template <class Scene>
void advance(Scene& scene, Guard<3>* guard) {
    for (int k = 0; k < steps; ++k) {
        scene.step(1e-6);
        if (guard)
            (*guard)(scene);
    }
}
// Wide bounds: the scene begins under stress, with water in the reach of the sponge's repulsion.
const GuardSettings<3> bounds{.energy = 100};

template <class Scene>
double count(Scene scene, bool guarded) {
    Guard<3> guard(bounds);
    advance(scene, guarded ? &guard : nullptr);
    bench::count([&] { advance(scene, guarded ? &guard : nullptr); });
    return steps;
}
template <class Scene>
double microseconds(Scene scene, bool guarded) {
    Guard<3> guard(bounds);
    return bench::shortest_seconds(6, [&] { advance(scene, guarded ? &guard : nullptr); }) * 1e6 / steps;
}

struct Case {
    double (*count)();
    double (*microseconds)();
};
template <bool guarded = false, class Make>
Case of(Make) {
    return {[] { return count(Make{}(), guarded); }, [] { return microseconds(Make{}(), guarded); }};
}

} // namespace

int main(int argc, char** argv) {
    const std::map<std::string, Case> cases{
        {"sponge_alone", of([] { return alone<Sponge>(dry); })},
        {"water_alone", of([] { return alone<Water, Vessel, Walls>(dry); })},
        {"walls_twice", of([] { return alone<Water, Vessel, Walls>(dry, true); })},
        {"out_of_reach", of([] { return together(dry); })},
        {"within_reach", of([] { return together(wet); })},
        {"guarded", of<true>([] { return together(wet); })},
    };
    const std::string last = argc > 1 ? argv[argc - 1] : "";
    if (argc == 2 && cases.contains(last)) {
        std::printf("items %.0f\n", cases.at(last).count());
        return 0;
    }
    if (argc == 3 && std::string(argv[1]) == "--time" && cases.contains(last)) {
        std::printf("microseconds %.1f\n", cases.at(last).microseconds());
        return 0;
    }
    for (const auto& [name, it] : cases)
        std::printf("case %s\n", name.c_str());
    bench::print_compiler();
    return argc == 1 ? 0 : 2;
}
