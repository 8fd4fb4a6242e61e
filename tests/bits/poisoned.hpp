// Runs loops as a device would that holds only what they declare: what a scene computes there must have the same bits.
#pragma once

#include <imbibe/solver/scene_engine.hpp>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace imbibe_test {

/// Calls bodies one block after the other, from the last to the first, while every column that the loop does not
/// declare holds no number. What is written there is lost.
template <int dim, class Real>
class Poisoned final : public imbibe::detail::Space<dim, Real> {
    using Engine = imbibe::detail::SceneEngine<dim, Real>;
    using Loop = imbibe::detail::Loop<dim, Real>;

    struct Columns {
        Real* begin;
        std::vector<Real> held;
    };
    static void poison(std::vector<Columns>& all, Real* begin, std::size_t count) {
        all.push_back({begin, {begin, begin + count}});
        std::fill_n(begin, count, std::numeric_limits<Real>::quiet_NaN());
    }

public:
    void launch(Engine& scene, const Loop& loop) const override {
        std::vector<Columns> poisoned;
        for (int p = 0; p < static_cast<int>(scene.phases.size()); ++p) {
            auto& phase = scene.phase(p);
            if (phase.size() == 0)
                continue;
            const auto& fields = phase.row->fields;
            for (std::size_t f = 0; f < fields.size(); ++f) {
                const int bit = phase.row->first_bit + static_cast<int>(f);
                const bool own = p == loop.phase && (loop.reads_own.test(bit) || loop.writes.test(bit));
                const bool near = loop.reads_near.test(bit);
                for (int k = fields[f].first; k < fields[f].first + fields[f].components; ++k) {
                    if (!own && !near)
                        poison(poisoned, phase.column(k), phase.stride());
                    if (const Real* const seen = scene.seen_of(p).column(k); seen != nullptr && !near)
                        poison(poisoned, const_cast<Real*>(seen), phase.stride());
                }
            }
        }
        const int block = loop.sweep ? imbibe::search::RunList::smallest_block : 512;
        const int size = scene.phase(loop.phase).size();
        for (int k = (size - 1) / block; k >= 0; --k)
            loop.body(scene, k * block, std::min((k + 1) * block, size));
        for (const Columns& columns : poisoned)
            std::copy(columns.held.begin(), columns.held.end(), columns.begin);
    }
};

} // namespace imbibe_test
