// PressureExtrapolation: exact for still water below, beside and above the wall; nothing where there is no water.
#include "cloud.hpp"

#include <imbibe/wall/pressure_extrapolation.hpp>

namespace pressure_extrapolation_test {

using namespace cloud;

namespace {

using Bed = Wall<>;
using Term = PressureExtrapolation<>;

Water water_here() {
    return {.density = 1000, .sound_speed = 30, .viscosity = 1e-3, .support_radius = 2.6e-3, .spacing = 1e-3};
}
Bed bed() {
    return {.density = 1000, .support_radius = 2.6e-3, .spacing = 1e-3};
}

template <int dim>
struct Tank {
    Cloud<dim, Water> water = block<dim>(water_here(), 4, 0.2, 1);
    Cloud<dim, Bed> wall;
    ColumnVector<dim> g = ColumnVector<dim>::Constant(0.3);
    double rho = 1020; // water that is compressed weighs more than at rest

    explicit Tank(double surface_pressure) {
        g[dim - 1] = -9.81;
        int seed = 2;
        for (int d = 0; d < dim; ++d)
            for (const double side : {-3.5e-3, 3.5e-3}) { // beside, below and above
                ColumnVector<dim> at = ColumnVector<dim>::Zero();
                at[d] = side;
                const auto more = block<dim>(bed(), 4, 0.2, static_cast<unsigned>(seed++), at);
                wall.insert(wall.end(), more.begin(), more.end());
            }
        for (auto& p : water)
            p.set(density, rho).set(pressure, at(p, surface_pressure));
    }
    template <class P>
    double at(const P& p, double surface_pressure) const {
        return surface_pressure + rho * g.dot(plain(p[position]));
    }
    template <class P>
    double pressure_of(P& a, const Term::Parameters& parameters = {}) const {
        Number<double> weight = 0, total = 0;
        for (const auto& b : water) {
            const auto [w, s] = Term::Sum{}(a, b, geometry<Term::Sum, dim>(a, b, g));
            weight += w;
            total += s;
        }
        a.set(extrapolation_weight, weight).set(extrapolation_sum, total);
        return plain(Term::Divide{parameters}(a));
    }
};

template <int dim>
void check_still_water() {
    Tank<dim> tank(500);
    int touching = 0, apart = 0;
    for (auto& a : tank.wall) {
        const double p = tank.pressure_of(a);
        if (plain(a[extrapolation_weight]) > 0) {
            ++touching;
            CHECK(p == Approx(tank.at(a, 500)).epsilon(1e-12));
        } else {
            ++apart;
            CHECK(p == 0);
        }
    }
    CHECK(touching > 10);
    CHECK(apart > 0);
}

} // namespace

TEST_CASE("PressureExtrapolation is exact for still water on all sides of it") {
    check_still_water<2>();
    check_still_water<3>();
}

TEST_CASE("PressureExtrapolation: a wall that must not pull shows no negative pressure") {
    Tank<2> tank(-500);
    int pulling = 0;
    for (auto& a : tank.wall) {
        const double p = tank.pressure_of(a), clipped = tank.pressure_of(a, {.suction = false});
        pulling += p < 0;
        CHECK(clipped == std::max(p, 0.0));
    }
    CHECK(pulling > 10);
}

} // namespace pressure_extrapolation_test
