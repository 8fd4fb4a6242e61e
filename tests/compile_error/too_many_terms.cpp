// More terms than one loop of the schedule has room for.
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
template <class Sequence>
struct Many;
template <int... k>
struct Many<std::integer_sequence<int, k...>> : sph::Fluid<Fill<k>...> {};
struct Air : Many<std::make_integer_sequence<int, 60>> {};
using Scene = sph::Solver<2, double, sph::SymplecticEuler, Air>;

int main() {
    Scene scene({.support_radius = 0.1});
    scene.run_until(1);
}
