// Half a metre of water on a soft elastic plate, through every coupling of cases/couplings: how far the plate
// hangs down. After Fourey et al. (2017), with a softer plate and less water; docs/validation.md and docs/coupling.md
// have it at other spacings and support radii.
#include <cases/validation/soft_plate.hpp>
#include <catch_shim.hpp>
#include <sanitized.hpp>

#include <cmath>
#include <vector>

namespace plate_couplings {

namespace plate = couplings::plate;

/// The extrapolated pressure, and beside it a guard that has nothing to do.
struct Guarded : couplings::Extrapolated {
    template <class Water, class Solid>
    struct Contact
        : imbibe::Coupling<Water, Solid, imbibe::Into<Solid, imbibe::PressureExtrapolation<couplings::K>>,
                           imbibe::VolumePressure<couplings::K>,
                           imbibe::Into<Water, imbibe::VolumeContinuity<couplings::K>>, imbibe::ModifiedRepulsion> {};
    static void set(auto& contact, const couplings::Load& load, const couplings::Layers& layers) {
        couplings::Extrapolated::set(contact, load, layers);
        contact.set(imbibe::ModifiedRepulsionParameters{.speed = 1, .range = 0.7});
    }
};

/// How far the plate hangs down with the water on it, m; the water's spacing is twice the plate's.
template <class Kit>
double wet_sag(int layers, double modulus) {
    const auto seen = plate::wet_sag<Kit>({2 * plate::thickness / layers, 2.6, 0.4}, modulus);
    CAPTURE(Kit::name, layers, seen.failure);
    REQUIRE(seen.failure.empty());
    return seen.curve.back();
}

// Four layers, under water with a spacing of 25 mm: of the spacings of docs/coupling.md the one at which all six are
// within 4 % there. The modified repulsion misses it by 2 % at 20 mm, the stiff K_f is 2 % off at 12.5 mm. The plate
// alone is 15 % too soft; what the coupling adds to that is looked at here.
TEST_CASE("Water on a soft plate weighs the same through every coupling", "[validation][solid]") {
    constexpr int layers = 4;
    const double dry = plate::dry_sag(plate::thickness / layers);
    const auto check = [&]<class Kit>(Kit) {
        const double share = wet_sag<Kit>(layers, plate::young_modulus) / dry;
        CAPTURE(Kit::name, share);
        CHECK(share == Approx(1).epsilon(0.04));
        return share;
    };
    const double extrapolated = check(couplings::Extrapolated{});
    check(couplings::Riemann{});
    check(couplings::AlongNormals{});
    check(couplings::ModifiedRepulsion{});
    check(couplings::StiffRepulsion{});
    check(couplings::ScaledRepulsion{});
    CHECK(check(Guarded{}) == Approx(extrapolated).epsilon(0.001));
}

// Five layers with their bending modulus: the couplings by pressure add nothing to the plate's own error, which is 6.7
// % with so few.
TEST_CASE("Water on a soft plate of five layers weighs what it does, by pressure", "[validation][solid]") {
    constexpr int layers = 5;
    const double modulus = imbibe::bending_modulus(plate::young_modulus, layers);
    const double dry = plate::dry_sag(plate::thickness / layers, modulus);
    const std::vector<double> shares{wet_sag<couplings::Extrapolated>(layers, modulus) / dry,
                                     wet_sag<couplings::Riemann>(layers, modulus) / dry,
                                     wet_sag<couplings::AlongNormals>(layers, modulus) / dry};
    CAPTURE(shares);
    for (const double share : shares)
        CHECK(share == Approx(1).epsilon(0.01));
}

TEST_CASE("Water bends a soft plate of ten layers as elasticity says", "[validation][solid]") {
    if (imbibe_test::left_out("minutes; the same with fewer layers has run above"))
        return;
    const double sag = wet_sag<couplings::Riemann>(10, imbibe::bending_modulus(plate::young_modulus, 10));
    CAPTURE(sag);
    CHECK(sag == Approx(2.10e-3).epsilon(0.04)); // the reference's own tolerance
}

} // namespace plate_couplings
