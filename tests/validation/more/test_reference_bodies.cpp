// Bodies that do not lie along the lattice, against what one expects of them at any angle.
#include <catch_shim.hpp>

#include <cases/validation/fitted_bodies.hpp>
#include <cases/validation/fitted_cylinders.hpp>
#include <cases/validation/ramp.hpp>
#include <cases/validation/turned_beam.hpp>

namespace reference_bodies_test {

TEST_CASE("A beam of fitted particles bends at an angle as it does along the lattice", "[validation][solid]") {
    using validation::turned_beam::deflection;
    using Placing = validation::turned_beam::Placing;
    const double along = deflection(0, 4, 1.5, Placing::fitted);
    CHECK(along == Approx(1.15).margin(0.05)); // with four layers; 1/15 of it is the sum over the layers
    CHECK(deflection(30, 4, 1.5, Placing::fitted) == Approx(along).epsilon(0.01));
    CHECK(deflection(30, 4, 1.5, Placing::filled) > 1.5);
}

TEST_CASE("A ring, a ball and a plate with a hole of fitted particles deform nearly as theory has it",
          "[validation][solid]") {
    using namespace validation::fitted_bodies;
    CHECK(ring(12) == Approx(1.05).margin(0.02));
    CHECK(ball(6) == Approx(1.025).margin(0.01));
    const Plate with_hole = plate(12);
    CHECK(with_hole.stretch == Approx(1).margin(0.015));
    CHECK(with_hole.stress == Approx(0.97).margin(0.015));
}

TEST_CASE("Water slips down a ramp of fitted particles as fast as it falls", "[validation][fluid]") {
    CHECK(validation::ramp::speed(10, 5, false) == Approx(1).epsilon(0.02));
    CHECK(validation::ramp::speed(10, 5, true) < 0.6);
}

TEST_CASE("The drag of cylinders of fitted particles is known within 2 % where the walls' shown velocity counts",
          "[validation][fluid]") {
    using namespace validation::fitted_cylinders;
    CHECK(drag(25, 0.2) == Approx(51.53).epsilon(0.02)); // Sangani and Acrivos (1982)
    CHECK(drag(25, 0.3) == Approx(102.9).epsilon(0.02));
    CHECK(drag<OwnVelocity>(25, 0.3) < 0.96 * 102.9);
}

} // namespace reference_bodies_test
