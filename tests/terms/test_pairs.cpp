// What every pair part must keep to: action and reaction, silence beyond the support, and a finite and empty self pair.
#include "every_part.hpp"

#include <algorithm>

namespace pairs_test {

using namespace hand;

namespace {

// The positions are not rounded once more in float: both sides of a pair see the same offset.
template <class Real, int dim, class Part, class A, class B>
std::pair<std::vector<double>, std::vector<double>> forces(const Part& part, const A& a, const B& b) {
    using T = Number<Real>;
    const auto a_ = as<T>(a);
    const auto b_ = as<T>(b);
    const auto ab = pair_of(a_, b_), ba = pair_of(b_, a_);
    return {numbers(a_[mass] * contribution(ab, part(a_, b_, ab))),
            numbers(b_[mass] * contribution(ba, part(b_, a_, ba)))};
}

// The assertions are not templates: the compiler would expand them for every part.
double greatest(const std::vector<double>& v) {
    double m = 0;
    for (const double x : v)
        m = std::max(m, std::abs(x));
    return m;
}

void check_opposite(const std::vector<double>& on_a, const std::vector<double>& on_b, double last_bit) {
    const double size = greatest(on_a);
    for (std::size_t i = 0; i < on_a.size(); ++i)
        REQUIRE(std::abs(on_a[i] + on_b[i]) <= 4 * last_bit * size);
}

void check_zero(const std::vector<double>& v) {
    for (const double x : v)
        REQUIRE(x == 0);
}

void check_finite(const std::vector<double>& v) {
    for (const double x : v)
        REQUIRE(std::isfinite(x));
}

template <class Real, int dim>
void check_action_and_reaction() {
    for_each_case(EveryPairPart<dim>{}, []<class C>(C) {
        if constexpr (C::is_force) {
            Dice dice(200 + dim);
            int not_zero = 0;
            for (int k = 0; k < 300; ++k) {
                const auto a = ready_particle<typename C::A>(dice, dice.vector<dim>(0.4 * H));
                auto b = ready_particle<typename C::B>(dice, dice.vector<dim>(0.4 * H));
                const auto [on_a, on_b] = forces<Real, dim>(typename C::Part{}, a, b);
                check_opposite(on_a, on_b, static_cast<double>(std::numeric_limits<Real>::epsilon()));
                b.set(mass, a[mass]); // with equal masses to the last bit
                const auto [same_a, same_b] = forces<Real, dim>(typename C::Part{}, a, b);
                check_opposite(same_a, same_b, 0);
                not_zero += greatest(on_a) > 0;
            }
            CHECK(not_zero > 50);
        }
    });
}

template <class Real, int dim>
void check_beyond_the_support_and_self() {
    using T = Number<Real>;
    for_each_case(EveryPairPart<dim>{}, []<class C>(C) {
        Dice dice(300 + dim);
        const typename C::Part part{};
        for (int k = 0; k < 50; ++k) {
            const auto a = as<T>(ready_particle<typename C::A>(dice, Vector<Number<double>, dim>::zero()));
            auto direction = dice.vector<dim>(1);
            // What lies behind a run in the order of the cells may be anywhere in the scene.
            const double reach = k % 2 == 0 ? dice(1.001, 3) : std::pow(10, dice(0.5, 6));
            const auto far = (reach * H / norm(direction)) * direction;
            const auto b = as<T>(ready_particle<typename C::B>(dice, far));
            const auto ab = pair_of(a, b);
            check_zero(numbers(contribution(ab, part(a, b, ab))));
            // another particle in the same place: finite; the particle itself: nothing
            const auto twin = as<T>(ready_particle<typename C::B>(dice, Vector<Number<double>, dim>::zero()));
            const auto here = pair_of(a, twin);
            check_finite(numbers(contribution(here, part(a, twin, here))));
            if constexpr (std::is_same_v<typename C::A, typename C::B>)
                check_zero(numbers(contribution(pair_of(a, a), part(a, a, pair_of(a, a)))));
        }
    });
}

} // namespace

TEST_CASE("forces of a pair are equal and opposite, to the last bit for equal masses") {
    check_action_and_reaction<double, 2>();
    check_action_and_reaction<double, 3>();
    check_action_and_reaction<float, 2>();
    check_action_and_reaction<float, 3>();
}

TEST_CASE("pair parts are zero beyond the support, and finite at distance zero") {
    check_beyond_the_support_and_self<double, 2>();
    check_beyond_the_support_and_self<double, 3>();
    check_beyond_the_support_and_self<float, 2>();
    check_beyond_the_support_and_self<float, 3>();
}

} // namespace pairs_test
