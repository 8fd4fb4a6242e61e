// Every pair part, and every particle function that says so, gives on packs of every width that a processor may ask for
// what it gives on single numbers.
#include "every_part.hpp"

#include <imbibe/solid/cauchy_stress.hpp>
#include <imbibe/solid/hughes_winget.hpp>
#include <imbibe/solid/jaumann_stress.hpp>
#include <imbibe/solid/neo_hookean.hpp>
#include <imbibe/state/linear_state.hpp>
#include <imbibe/state/tait.hpp>

#include <algorithm>

namespace packs_test {

using namespace hand;

namespace {

/// All results of a pair part in plain double, one after the other.
template <int dim, class T, class R>
std::vector<double> results(const Pair<dim, T>& ab, const R& result, int lane = 0) {
    if constexpr (detail::is_tuple<R>) {
        std::vector<double> all;
        std::apply(
            [&](const auto&... one) {
                (
                    [&] {
                        const auto n = numbers(contribution(ab, one), lane);
                        all.insert(all.end(), n.begin(), n.end());
                    }(),
                    ...);
            },
            result);
        return all;
    } else {
        return numbers(contribution(ab, result), lane);
    }
}

/// A random particle. Numbers that may cancel but for a rest are kept apart, so that their last bits are not compared
/// with that rest: at a Riemann wall the pressure and what the approach adds to it, by a pressure above 0; in pores the
/// densities rho/n of the fluid itself of a particle and its neighbour, by a neighbour with a quarter of the porosity.
template <class C, class Material, int dim>
auto particle_for(Dice& dice, Vector<Number<double>, dim> where, bool neighbour = false) {
    auto p = ready_particle<Material>(dice, where);
    if constexpr (detail::contains<WallDirection, typename C::Part::reads>)
        p.set(pressure, abs(p[pressure]));
    if constexpr (detail::contains<Porosity, typename C::Part::reads>)
        p.set(porosity, (neighbour ? 0.25 : 1) * p[porosity]);
    return p;
}

/// Results of packs beside those of single numbers; not a template, as the compiler would expand its assertions for
/// every part and width.
struct Comparison {
    double size = 0, error = 0; ///< the greatest number, and the greatest difference in shares of its pair's greatest

    /// @param room how far within the support the pair is, in supports. Near the rim a kernel is (1 - q)^n: an error of
    /// the last bit in q weighs n/(1 - q).
    void compare(const std::vector<double>& one, const std::vector<double>& many, double room) {
        REQUIRE(one.size() == many.size());
        double greatest = 1e-300;
        for (const double x : one)
            greatest = std::max(greatest, std::abs(x));
        size = std::max(size, greatest);
        for (std::size_t i = 0; i < one.size(); ++i) {
            REQUIRE(std::isfinite(many[i]));
            if (room > 1e-4)
                error = std::max(error, room * std::abs(one[i] - many[i]) / greatest);
            else if (room < -1e-4)
                REQUIRE((one[i] == 0 && many[i] == 0));
        }
    }
    /// The two may differ where the compiler fuses products, and by the last bit of roots and quotients; twelfth powers
    /// carry that difference on.
    void check(double last_bit) const {
        CHECK(size > 1e-300);
        CHECK(error < 50 * last_bit);
    }
};

template <class Real, int width, int dim, class C>
void check_part() {
    using T = Pack<Real, width>;
    Dice dice(400 + dim);
    const typename C::Part part{};
    Comparison seen;
    for (int k = 0; k < 20; ++k) {
        const auto a = particle_for<C, typename C::A>(dice, Vector<Number<double>, dim>::zero());
        std::vector<Particle<dim, Number<double>, typename C::B>> neighbours;
        for (int lane = 0; lane < width; ++lane) { // inside and outside the support, and one on top of a
            const auto where = dice.vector<dim>(lane == 0 ? 0 : 0.7 * H);
            neighbours.push_back(particle_for<C, typename C::B>(dice, where, true));
        }
        const auto a_ = as<T>(a);
        const auto b_ = lanes<T>(neighbours);
        auto ab = pair_of(a_, b_);
        ab.gravity_now = Vector<double, dim>::filled(-3.0);
        const auto all = part(a_, b_, ab);
        for (int lane = 0; lane < width; ++lane) {
            const auto a1 = as<Number<Real>>(a);
            const auto b1 = as<Number<Real>>(neighbours[static_cast<std::size_t>(lane)]);
            auto ab1 = pair_of(a1, b1);
            ab1.gravity_now = ab.gravity_now;
            const auto one = results(ab1, part(a1, b1, ab1));
            const auto many = results(ab, all, lane);
            const double room = 1 - plain(ab1.distance) / H;
            seen.compare(one, many, room);
        }
    }
    seen.check(static_cast<double>(std::numeric_limits<Real>::epsilon()));
}

using InPacks =
    TypeList<LinearState, Tait<7>, Volume, SymmetricPressure<Spiky>::Prepare, StressForce<Spiky>::Prepare,
             CorrectedStressForce<>::Prepare, JaumannStress, HughesWingetStress<>, ParticleShifting<>::Detect,
             ParticleShifting<>::Shift, AntuonoDiffusion<>::Correct, Displacement, DeformationGradient<>::Correct,
             StVenantKirchhoff, CompressibleNeoHookean, IsochoricNeoHookean, CauchyStress,
             TotalLagrangianForce<>::Prepare, Xsph<Poly6>::Smooth, XsphTransport>;

/// Gives a particle some number for every field of Part's that it has none for.
template <int dim, class P, class... F>
void fill_in(Dice& dice, P& particle, TypeList<F...>) {
    const auto one = [&]<class G>(std::type_identity<G>) {
        if (particle.values_.contains(G::name))
            return;
        Value<G, dim, Number<double>> value{};
        for (int k = 0; k < components(G::rank, dim); ++k)
            component(value, k) = Number<double>(dice(0.5, 1.5));
        particle.set(G{}, value);
    };
    (one(std::type_identity<F>{}), ...);
}

template <class Real, int width, int dim, class Part>
void check_particle_function() {
    static_assert(detail::is_in_packs<Part>);
    using T = Pack<Real, width>;
    Dice dice(500 + dim);
    Comparison seen;
    for (int k = 0; k < 20; ++k) {
        std::vector<Particle<dim, Number<double>, Sponge>> particles;
        for (int lane = 0; lane < width; ++lane) {
            particles.push_back(ready_particle<Sponge>(dice, dice.vector<dim>(0.7 * H)));
            fill_in<dim>(dice, particles.back(), typename Part::reads{});
        }
        const auto all = Part{}(lanes<T>(particles));
        for (int lane = 0; lane < width; ++lane) {
            const auto one = Part{}(as<Number<Real>>(particles[static_cast<std::size_t>(lane)]));
            seen.compare(numbers(one), numbers(all, lane), 1);
        }
    }
    seen.check(static_cast<double>(std::numeric_limits<Real>::epsilon()));
}

template <class Real, int width, int dim>
void check_every_part() {
    INFO(width << " numbers of " << sizeof(Real) << " bytes in " << dim << "D");
    [&]<class... Part>(TypeList<Part...>) { (check_particle_function<Real, width, dim, Part>(), ...); }(InPacks{});
    for_each_case(EveryPairPart<dim>{}, []<class C>(C) { check_part<Real, width, dim, C>(); });
    for_each_case(OtherPairParts{}, []<class C>(C) { check_part<Real, width, dim, C>(); });
}

} // namespace

TEST_CASE("a pack of neighbours gives what each of them gives alone, in packs of 16 bytes") {
    check_every_part<float, 4, 3>();
    check_every_part<double, 2, 3>();
}
TEST_CASE("a pack of neighbours gives what each of them gives alone, in packs of 32 bytes") {
    check_every_part<float, 8, 3>();
    check_every_part<double, 4, 3>();
}
TEST_CASE("a pack of neighbours gives what each of them gives alone, in packs of 64 bytes") {
    check_every_part<float, 16, 3>();
    check_every_part<double, 8, 3>();
}
TEST_CASE("a pack of neighbours gives what each of them gives alone, in the plane") {
    check_every_part<float, 8, 2>();
    check_every_part<double, 4, 2>();
}

} // namespace packs_test
