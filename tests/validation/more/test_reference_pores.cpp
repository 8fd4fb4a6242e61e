// Pores too small to resolve: a wet layer is pressed and drains, a dry column draws water in, one sponge both resolved
// and mixed; docs/validation.md has them finer.
#include <cases/validation/biot.hpp>
#include <cases/validation/frozen_pores.hpp>
#include <cases/validation/imbibition.hpp>
#include <cases/validation/slotted_sponge.hpp>

#include <imbibe/porous/resolve_or_mix.hpp>

#include <catch_shim.hpp>

TEST_CASE("A layer of wet soil that is pressed drains as Terzaghi says", "[validation][mixture]") {
    for (const auto& found : validation::biot::measure_layer(20)) {
        CAPTURE(found.what, found.computed, found.reference);
        CHECK(std::abs(found.error()) < 0.08); // 2 % is asked of 40
    }
}

TEST_CASE("Suction draws a front into a dry column as Green and Ampt say", "[validation][mixture]") {
    for (const auto& found : validation::imbibition::measure(40)) {
        CAPTURE(found.what, found.computed, found.reference);
        CHECK(std::abs(found.error()) < 0.02);
    }
}

TEST_CASE("Water freezes in pores as Stefan says with n L and the mean conductivity, in motion too",
          "[validation][mixture]") {
    for (const auto& found : validation::frozen_pores::measure(20)) {
        CAPTURE(found.what, found.computed, found.reference);
        const bool exact = found.good == "1e-12", in_place = found.what.starts_with("ice");
        CHECK(std::abs(found.error()) < (exact ? 1e-12 : in_place ? 0.02 : 1e-3)); // 0.7 % with 40
    }
}

TEST_CASE("One sponge, resolved and mixed, is as far off as resolve_or_mix says", "[validation][mixture]") {
    using namespace validation::slotted_sponge;
    // permeability, time of drainage, sag
    const auto off = [](const std::vector<validation::Measured>& found, int which) {
        return std::abs(found[static_cast<std::size_t>(which)].error());
    };
    imbibe::PorousBody body{.thickness = L, .porosity = n, .pore_width = slot, .permeability = k};
    for (const int across : {4, 8}) {
        CAPTURE(across);
        const auto found = resolved::measure(across);
        body.spacing = slot / across;
        const auto said = imbibe::resolve_or_mix(body);
        CHECK(off(found, 0) < said.resolved_flow / 2); // slots are flat: about a third
        CHECK(off(found, 0) > said.resolved_flow / 8);
        CHECK(off(found, 1) < said.resolved_flow / 2);
        CHECK(off(found, 2) == Approx(said.sag).epsilon(0.15));
    }
    for (const int over : {10, 20, 40}) {
        CAPTURE(over);
        const auto found = mixed::measure(over);
        body.spacing = L / over;
        const auto said = imbibe::resolve_or_mix(body);
        if (over > 10) // five rows give no slope of the pressure
            CHECK(off(found, 0) < said.mixed_flow);
        CHECK(off(found, 1) < said.mixed_flow);
        CHECK(off(found, 2) == Approx(said.sag).epsilon(0.15));
    }
}
