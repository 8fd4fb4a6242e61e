// Slow flow under a pressure: finer, and in space.
#include <cases/validation/kolmogorov.hpp>

#include <catch_shim.hpp>

#include <cmath>

namespace slow = validation::kolmogorov;

TEST_CASE("Slow flow under a high pressure converges with CorrectedGradients", "[fluid]") {
    const double coarse = slow::flow<slow::Corrected>({.across = 32, .pressure = 100}).viscosity,
                 fine = slow::flow<slow::Corrected>({.across = 64, .pressure = 100}).viscosity;
    CAPTURE(coarse, fine);
    CHECK(std::abs(fine - 1) < 0.02);
    CHECK(std::abs(fine - 1) < 0.5 * std::abs(coarse - 1));
}

TEST_CASE("Slow flow under a high pressure in space", "[fluid]") {
    const slow::Run run{.across = 16, .pressure = 100, .end = 3};
    const double corrected = slow::flow<slow::Corrected, 3>(run).viscosity,
                 plain = slow::flow<slow::Plain, 3>(run).viscosity;
    CAPTURE(corrected, plain);
    CHECK(std::abs(corrected - 1) < 0.05);
    CHECK(plain > 2);
}
