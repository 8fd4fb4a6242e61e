// Whether to resolve the pores of a body or to mix: the answer, its numbers, what is refused.
#include <catch_shim.hpp>

#include <imbibe/porous/resolve_or_mix.hpp>

namespace resolve_or_mix_test {

using namespace imbibe;
using imbibe_test::contains;

TEST_CASE("resolve_or_mix: a kitchen sponge is mixed, a coarse filter resolved") {
    // 0.3 mm pores in 30 mm, with particles of 1.5 mm
    const auto kitchen = resolve_or_mix(
        {.thickness = 0.03, .porosity = 0.9, .pore_width = 3e-4, .permeability = 1e-9, .spacing = 1.5e-3});
    CHECK(kitchen.mix);
    CHECK(kitchen.resolved_flow == 1);
    CHECK(kitchen.mixed_flow == Approx(13.0 / 400 + 0.005));
    CHECK(kitchen.sag == Approx(2.6 / 20));
    CHECK(kitchen.times_particles == Approx(40 * 40 * 40));
    CHECK_THAT(kitchen.sentence, contains("Mix") && contains("64000 times"));

    const auto filter = resolve_or_mix({.thickness = 0.03, .porosity = 0.7, .pore_width = 5e-3, .spacing = 4e-4});
    CHECK_FALSE(filter.mix);
    CHECK(filter.across_pore == Approx(12.5));
    CHECK(filter.resolved_flow == Approx(9 / 156.25));
    CHECK(filter.permeability == Approx(0.7 * 2.5e-5 / 32));
    CHECK_THAT(filter.sentence, contains("Resolve"));
}

TEST_CASE("resolve_or_mix: what is not known follows from what is") {
    const auto by_permeability =
        resolve_or_mix({.thickness = 0.03, .porosity = 0.9, .permeability = 1e-9, .spacing = 1.5e-3});
    CHECK(by_permeability.pore_width == Approx(std::sqrt(32e-9 / 0.9)));
    // Pores of straight tubes: one from the other and back.
    const auto by_width = resolve_or_mix(
        {.thickness = 0.03, .porosity = 0.9, .pore_width = by_permeability.pore_width, .spacing = 1.5e-3});
    CHECK(by_width.permeability == Approx(1e-9));
    CHECK_THAT(by_width.sentence, contains("measure it"));
    const auto thin = resolve_or_mix({.thickness = 6e-3, .porosity = 0.9, .permeability = 1e-9, .spacing = 1e-3});
    CHECK_THAT(thin.sentence, contains("thinner than ten particles"));
}

TEST_CASE("resolve_or_mix: what is refused") {
    const PorousBody good{.thickness = 0.03, .porosity = 0.9, .pore_width = 3e-4, .spacing = 1.5e-3};
    const auto with = [&](auto change) {
        PorousBody body = good;
        change(body);
        return body;
    };
    CHECK_THROWS_WITH(resolve_or_mix(with([](auto& b) { b.spacing = 0; })), contains("spacing"));
    CHECK_THROWS_WITH(resolve_or_mix(with([](auto& b) { b.thickness = -1; })), contains("thickness"));
    CHECK_THROWS_WITH(resolve_or_mix(with([](auto& b) { b.porosity = 1; })), contains("porosity = 1"));
    CHECK_THROWS_WITH(resolve_or_mix(with([](auto& b) { b.pore_width = 0; })), contains("Give at least one"));
    CHECK_THROWS_WITH(resolve_or_mix(with([](auto& b) { b.permeability = -1; })), contains("permeability = -1"));
    CHECK_THROWS_WITH(resolve_or_mix(with([](auto& b) { b.pore_width = 1; })), contains("below the thickness"));
}

} // namespace resolve_or_mix_test
