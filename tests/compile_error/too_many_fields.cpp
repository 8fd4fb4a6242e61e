// More fields than the schedule has columns for.
// expect: the scene has more terms or fields than the schedule has room for
// expect: TooLarge<
// expect: use_fewer_terms_or_raise_the_limits_in_schedule_hpp
#include "scene.hpp"

template <int k>
struct Numbered : sph::Field<sph::Rank::scalar> {
    static constexpr std::string_view name = "numbered", unit = "1";
};
template <int k>
struct Fill {
    using reads = sph::Fields<sph::density>;
    using sets = sph::Fields<Numbered<k>{}>;
    constexpr auto operator()(const auto& a) const { return a[sph::density]; }
};
template <int first, class Sequence>
struct Many;
template <int first, int... k>
struct Many<first, std::integer_sequence<int, k...>> {
    using stores = sph::Fields<Numbered<first + k>{}...>;
};
using Hundred = std::make_integer_sequence<int, 100>;
struct One : sph::Fluid<Fill<0>, Many<1, Hundred>> {};
struct Two : sph::Fluid<Fill<0>, Many<1, Hundred>> {};
struct Three : sph::Fluid<Fill<0>, Many<1, Hundred>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, One, Two, Three>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
