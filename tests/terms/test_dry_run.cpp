// The dry run at compile time: every part passes it with the reads it declares, and it tells a's reads from b's.
#include "every_part.hpp"

#include <imbibe/core/dry_run.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>

namespace dry_run_test {

using namespace hand;

namespace {

template <class Part, int dim, class A, class B>
constexpr bool declares_what_it_reads() {
    return detail::check_all_read<Part, detail::reads_on<Part, dim, A, B>>(typename Part::reads{});
}
template <int dim, class A, class B, class... Part>
constexpr bool all_declare(TypeList<Part...>) {
    return (declares_what_it_reads<Part, dim, A, B>() && ...);
}
template <int dim, class Term, class A, class B = A>
constexpr bool term_declares() {
    return all_declare<dim, A, B>(detail::PartList<Term>{}) && all_declare<dim, B, A>(detail::PartList<Term>{});
}

template <int dim>
constexpr bool every_term_declares() {
    return term_declares<dim, Tait<>, Water>() && term_declares<dim, LinearState, Sponge>() &&
           term_declares<dim, Continuity<Spiky>, Water>() &&
           term_declares<dim, Continuity<Spiky, smoothed_velocity>, Sponge>() &&
           term_declares<dim, VolumeContinuity<Spiky>, Water, Sponge>() &&
           term_declares<dim, SymmetricPressure<Spiky>, Water, Sponge>() &&
           term_declares<dim, Laminar<dim>, Water, Sponge>() && term_declares<dim, Laminar<dim>, Water>() &&
           term_declares<dim, Laminar<dim>, Water, Wall<>>() &&
           term_declares<dim, MonaghanViscosity<Spiky>, Water, Sponge>() &&
           term_declares<dim, VelocityGradient<Spiky, smoothed_velocity>, Sponge>() &&
           term_declares<dim, JaumannStress, Sponge>() && term_declares<dim, StressForce<Spiky>, Sponge>() &&
           term_declares<dim, ArtificialStress<Spiky>, Sponge>() &&
           term_declares<dim, ArtificialStress<Spiky, ComponentWise, Poly6, 3>, Sponge>() &&
           term_declares<dim, Xsph<Poly6>, Sponge>() && term_declares<dim, XsphTransport, Sponge>() &&
           term_declares<dim, KernelRepulsion<>, Water, Sponge>();
}
static_assert(every_term_declares<2>());
static_assert(every_term_declares<3>());

/// Whether the part reads the field on a and on b, as "ab", "a", "b" or "".
template <class Part, class Field_, class A, class B = A>
std::string sides(const Field_&) {
    constexpr auto seen = detail::reads_on<Part, 3, A, B>;
    constexpr int k = detail::index_of<Field_, typename Part::reads>;
    return std::string(seen.a[k] ? "a" : "") + (seen.b[k] ? "b" : "");
}

} // namespace

TEST_CASE("the dry run sees which side of a pair is read") {
    using Push = SymmetricPressure<Spiky>::Push;
    CHECK(sides<Push, Mass, Water>(mass) == "b");
    CHECK(sides<Push, PressureOverDensity2, Water>(pressure_over_density2) == "ab");
    CHECK(sides<SymmetricPressure<Spiky>::Prepare, Pressure, Water>(pressure) == "a");

    CHECK(sides<Continuity<Spiky>, Mass, Water>(mass) == "b");
    CHECK(sides<Continuity<Spiky>, Velocity, Water>(velocity) == "ab");
    using Sweep = VolumeContinuity<Spiky>::Sweep;
    CHECK(sides<Sweep, Density, Water, Sponge>(density) == "a");
    CHECK(sides<Sweep, VolumeField, Water, Sponge>(volume) == "b");
    CHECK(sides<LaminarViscosity<>, Mass, Water>(mass) == "b");
    CHECK(sides<LaminarViscosity<>, Density, Sponge, Water>(density) == "ab");
    CHECK(sides<MonaghanViscosity<Spiky>, Mass, Sponge>(mass) == "b");

    using Gradient = VelocityGradient<Spiky, smoothed_velocity>;
    CHECK(sides<Gradient, Mass, Sponge>(mass) == "b");
    CHECK(sides<Gradient, Density, Sponge>(density) == "b");
    CHECK(sides<Gradient, SmoothedVelocity, Sponge>(smoothed_velocity) == "ab");

    CHECK(sides<StressForce<Spiky>::Push, Mass, Sponge>(mass) == "b");
    CHECK(sides<StressForce<Spiky>::Push, StressOverDensity2, Sponge>(stress_over_density2) == "ab");
    CHECK(sides<ArtificialStress<Spiky>::Push, Mass, Sponge>(mass) == "b");
    CHECK(sides<Xsph<Poly6>::Sum, Mass, Sponge>(mass) == "b");
    CHECK(sides<Xsph<Poly6>::Sum, Density, Sponge>(density) == "ab");
    CHECK(sides<KernelRepulsion<>, Mass, Water, Sponge>(mass) == "b");
    CHECK(sides<KernelRepulsion<>, Density, Water, Sponge>(density) == "ab");
}

} // namespace dry_run_test
