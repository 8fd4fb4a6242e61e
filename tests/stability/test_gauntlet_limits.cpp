// Every limit of the time step against the longest step that holds, in the scenes of docs/stability.md, "Limits".
#include <catch_shim.hpp>

#include "stability/rows.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace {

using stability::Row;

// Those of which docs/stability.md says why they are longer or shorter than what holds.
constexpr std::array explained_as_short{"Tait<7>, Spiky, H = 1.25",       "DensityFloor, rate = 20",
                                        "SummationFloor, rate = 20",      "paper's hypoelastic, nu 0.3",
                                        "KernelRepulsion within a phase", "ParticleShifting, H = 2.6",
                                        "ParticleShifting, H = 3",        "ParticleShifting, H = 4"};
constexpr std::array explained_as_long{"LinearState, WendlandC2, H = 1.25, rough"};

// Each of these limits some scene.
constexpr std::array reasons{"sound",
                             "density floor",
                             "density diffusion",
                             "viscosity",
                             "viscous diffusion",
                             "artificial viscosity",
                             "elastic wave",
                             "hourglass stiffness",
                             "solid viscosity",
                             "repulsion",
                             "repulsion stiffness",
                             "corrected gradients",
                             "Riemann dissipation",
                             "Riemann dissipation at the wall",
                             "Riemann smoothing of the density",
                             "spring",
                             "pressure between phases",
                             "summation floor",
                             "summation relaxation",
                             "particle shifting"};

bool is_among(const auto& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace

TEST_CASE("every predicted limit holds, and steps 1.6 times as long do not; so with what scenes say themselves") {
    stability::Table table;
    stability::add_limits(table);
    int predicted = 0, asked_of = 0;
    std::set<std::string> limited_by;
    for (const Row& row : table.rows) {
        CAPTURE(row.composition, row.scene);
        const auto at = [&](double cfl) {
            const auto out = row.run({.cfl = cfl, .value = row.value});
            limited_by.insert(out.limit);
            return out.stable;
        };
        if (!is_among(explained_as_long, row.composition))
            CHECK(at(0.9));
        // What the scene says itself, for which no limit of a term counts; beyond 4 nothing was bisected.
        if (const double asked = row.run({.cfl = 0.4, .value = row.value, .ask = true}).asked; asked > 0 && asked < 4) {
            CAPTURE(asked);
            CHECK(at(0.85 * asked));
            CHECK_FALSE(at(2.2 * asked));
            ++asked_of;
        }
        if (!is_among(explained_as_short, row.composition)) {
            CHECK_FALSE(at(1.6));
            ++predicted;
        }
    }
    CHECK(predicted > 30);
    CHECK(asked_of > 40);
    for (const char* reason : reasons) {
        CAPTURE(reason);
        CHECK(limited_by.count(reason) == 1);
    }
}
