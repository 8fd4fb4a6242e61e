// One row of pores of the paper's sponge, r = 1.5 mm, under 14 mm of water that falls on it, in the sound composition
// (presets/sponge.hpp), or with corrected gradients in the water: the mean displacement of the sponge until 0.15 s,
// beside the finest run, of 20 water particles to the period of 7 mm. The error is the root mean square of the
// difference, as a share of the finest run's own. The sponge keeps the paper's 0.5 mm: its particles lie on both faces
// of the slab, so that a finer one would be a thinner slab as well.
#include "cases.hpp"

#include <imbibe/imbibe.hpp>
#include <imbibe/presets/sponge.hpp>

#include <cmath>

namespace cost {
namespace {

using sph::presets::SoundSponge;

/// SoundSponge with the method CorrectedGradients in the water, shifting in shear included; walls may attract it.
struct CorrectedSponge : SoundSponge {
    struct Water : sph::Fluid<sph::LinearState, sph::CorrectedGradients<K>, sph::MorrisViscosity<K>,
                              sph::MonaghanViscosity<K>, sph::KernelRepulsion<sph::Spiky>> {};
    struct Contact : sph::CouplingOf<Water, Sponge, sph::KernelRepulsion<sph::Spiky>> {};
    struct Sides : sph::CouplingOf<Water, Vessel, sph::KernelRepulsion<sph::Spiky>> {};
    template <class Real>
    using Scene = sph::Solver<3, Real, sph::Subcycled<Sponge>, Water, Sponge, Vessel, Contact, Sides>;
};

constexpr double end = 0.15, samples = 150;

/// What a run shows.
struct Swing {
    std::vector<double> displacement; ///< mean of the sponge, m, at equal times
    double pair_evaluations;
};

/// @param across water particles to the period of the pores
template <class Composition, class Real>
Swing swing(double across, double support, double cfl, int search_interval) {
    sph::presets::SpongeCase numbers;
    numbers.strip = true;
    numbers.pool = 14e-3;
    numbers.pore_radius = 1.5e-3;
    numbers.water_spacing = 7e-3 / across;
    numbers.support_ratio = support;
    numbers.cfl = cfl;
    numbers.search_interval = search_interval;
    numbers.threads = 1;
    auto scene = SoundSponge::make<Composition, Real>(numbers);
    const auto sponge = scene.template get<SoundSponge::Sponge>();
    const sph::DisplacementProbe<3> probe(sponge);
    Swing seen{};
    sph::Guard<3> guard;
    for (int k = 1; k <= samples; ++k) {
        scene.run_until(k * end / samples, [&](auto& s) {
            if (s.steps() % 20 == 0)
                s.remove_if(sph::PhaseHandle<typename Composition::Water>{},
                            [&](const sph::Point<3>& x) { return x[2] < -numbers.drain; });
            guard(s);
        });
        seen.displacement.push_back(probe.mean(sponge));
    }
    seen.pair_evaluations = accuracy::pair_evaluations(scene);
    return seen;
}

template <class Composition, class Real>
Swing chosen(const accuracy::Choices& choose) {
    return swing<Composition, Real>(choose.number("across"), choose.number("support"), choose.number("cfl"),
                                    static_cast<int>(choose.number("search interval")));
}

const Compositions<Swing> compositions({{"precision", "float"}, {"gradients", "plain"}},
                                       {{{}, chosen<SoundSponge, float>},
                                        {{{"precision", "double"}}, chosen<SoundSponge, double>},
                                        {{{"gradients", "corrected"}}, chosen<CorrectedSponge, float>}});

accuracy::Outcome sponge_by(const accuracy::Choices& choose, const Swing& finest) {
    const Swing seen = compositions(choose);
    double difference2 = 0, norm2 = 0;
    for (std::size_t k = 0; k < finest.displacement.size(); ++k) {
        difference2 += sph::sq(seen.displacement[k] - finest.displacement[k]);
        norm2 += sph::sq(finest.displacement[k]);
    }
    return {std::sqrt(difference2 / norm2), seen.pair_evaluations};
}

} // namespace

Rows sponge(accuracy::Study study, bool quick) {
    study.axis("across", quick ? Words{"7", "9"} : Words{"7", "9", "12"});
    compositions.add_to(study);
    study.axis("support", {"2.6", "2", "3"}).axis("cfl", {"0.75", "0.4", "1"}).axis("search interval", {"4", "1"});
    const Swing finest = swing<SoundSponge, float>(quick ? 10 : 20, 2.6, 0.75, 4);
    return study.one_at_a_time([&](const accuracy::Choices& choose) { return sponge_by(choose, finest); }, {"across"});
}

} // namespace cost
