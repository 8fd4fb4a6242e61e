// A column of water, twice as high as its width L = 0.146 m, that collapses in a tank of length 4 L (2D): how far its
// front has come at equal times until t sqrt(2 g/L) = 3, shortly before it meets the far wall. The error is the root
// mean square of the difference from the finest run, of 128 particles over L, as a share of the way of its front. The
// experiment of Koshizuka and Oka (1996) is no reference here: its water sticks to the floor and starts behind a gate
// that is pulled up (tests/validation/test_fluid.cpp).
#include "cases.hpp"

#include <imbibe/imbibe.hpp>

#include <cmath>

namespace cost {
namespace {

using C2 = sph::WendlandC2;

template <class... More>
using WeaklyCompressible = sph::Fluid<sph::LinearState, sph::VolumeContinuity<C2>, sph::DensityFloor,
                                      sph::VolumePressure<C2>, sph::MonaghanViscosity<C2>, More...>;
struct Diffusive : WeaklyCompressible<sph::DensityDiffusion<C2>> {};
struct Rough : WeaklyCompressible<> {};
struct Shifted : WeaklyCompressible<sph::DensityDiffusion<C2>, sph::ParticleShifting<C2>> {};
struct Corrected : sph::Fluid<sph::LinearState, sph::CorrectedGradients<C2>, sph::MonaghanViscosity<C2>> {};
struct Riemann : sph::Fluid<sph::LinearState, sph::RiemannContinuity<C2>, sph::DensityFloor, sph::RiemannPressure<C2>> {
};
struct Tank : sph::Wall<> {};

template <class Water>
struct Sides : sph::Coupling<Water, Tank, sph::Into<Tank, sph::PressureExtrapolation<C2>>, sph::VolumePressure<C2>,
                             sph::Into<Water, sph::VolumeContinuity<C2>>> {
    using Suction = sph::PressureExtrapolationParameters;
};
template <>
struct Sides<Corrected> : sph::CouplingOf<Corrected, Tank> {
    using Suction = sph::PressureExtrapolationParameters;
};
template <>
struct Sides<Riemann>
    : sph::Coupling<Riemann, Tank, sph::Into<Riemann, sph::RiemannWallNormal<C2>>, sph::RiemannWallPressure<C2>,
                    sph::Into<Riemann, sph::RiemannWallContinuity<C2>>> {
    using Suction = sph::RiemannWallPressureParameters;
};

constexpr double L = 0.146, g = 9.81;
constexpr int samples = 30;

/// What a run shows.
struct Front {
    std::vector<double> x; ///< how far the front is from the wall behind the water, m, at equal times
    double pair_evaluations;
};

template <class Water, class Real = double, class Integrator = sph::SymplecticEuler>
Front collapse(double across, double support, double cfl, int repetition = 0) {
    const double spacing = L / across;
    sph::Solver<2, Real, Integrator, Water, Tank, Sides<Water>> scene(
        {.gravity = {0, -g}, .support_radius = support * spacing, .cfl = cfl, .threads = 1});
    Water material{{.density = 1000, .sound_speed = 20 * std::sqrt(2 * g * L)}}; // ten times that of the front
    if constexpr (!std::is_same_v<Water, Riemann>)
        material.set(sph::MonaghanViscosityParameters{.alpha = 0.02});
    // From the second repetition on the particles are off their lattice by up to a twentieth of a spacing.
    const auto water = scene.add(material,
                                 sph::jitter(sph::fill(sph::Box<2>{{0, 0}, {L, 2 * L}}, spacing),
                                             repetition > 0 ? 0.05 * spacing : 0, static_cast<unsigned>(repetition)),
                                 spacing);
    scene.add(Tank{{.density = 1000}},
              sph::tank(sph::Box<2>{{0, 0}, {4 * L, 2.4 * L}}, spacing, static_cast<int>(std::ceil(support)),
                        sph::Sides::y_high),
              spacing);
    scene.template coupling<Sides<Water>>().set(typename Sides<Water>::Suction{.suction = false});
    Front front{};
    for (int k = 1; k <= samples; ++k) {
        scene.run_until(3 * std::sqrt(L / (2 * g)) * k / samples, sph::Guard<2>());
        front.x.push_back(static_cast<double>(scene[water][sph::position].col(0).maxCoeff()) + spacing / 2);
    }
    front.pair_evaluations = accuracy::pair_evaluations(scene);
    return front;
}

template <class Water, class Real = double, class Integrator = sph::SymplecticEuler>
Front chosen(const accuracy::Choices& choose) {
    return collapse<Water, Real, Integrator>(choose.number("across"), choose.number("support"), choose.number("cfl"),
                                             choose.repetition);
}

const Compositions<Front>
    compositions({{"scheme", "delta-SPH"}, {"integrator", "symplectic Euler"}, {"precision", "double"}},
                 {{{}, chosen<Diffusive>},
                  {{{"scheme", "without diffusion"}}, chosen<Rough>},
                  {{{"scheme", "shifted"}}, chosen<Shifted>},
                  {{{"scheme", "corrected gradients"}}, chosen<Corrected>},
                  {{{"scheme", "Riemann"}}, chosen<Riemann>},
                  {{{"integrator", "staggered leapfrog"}}, chosen<Diffusive, double, sph::StaggeredLeapfrog>},
                  {{{"precision", "float"}}, chosen<Diffusive, float>}});

} // namespace

Rows dam_break(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"16", "24"} : Words{"16", "24", "32", "48"});
    compositions.add_to(study);
    study.axis("support", {"2.6", "2", "3"}).axis("cfl", {"0.4", "0.2", "0.75"});
    const Front finest = collapse<Diffusive, float>(quick ? 64 : 128, 2.6, 0.4);
    return study.one_at_a_time(
        [&](const accuracy::Choices& choose) {
            const Front seen = compositions(choose);
            double difference2 = 0, way2 = 0;
            for (std::size_t k = 0; k < samples; ++k) {
                difference2 += sph::sq(seen.x[k] - finest.x[k]);
                way2 += sph::sq(finest.x[k] - L);
            }
            return accuracy::Outcome{std::sqrt(difference2 / way2), seen.pair_evaluations};
        },
        {"across"});
}

} // namespace cost
