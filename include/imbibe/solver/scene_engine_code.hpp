// The code of scene_engine.hpp: runs the loops of a pass.
#pragma once

#include <imbibe/solver/scene_engine.hpp>

namespace imbibe::detail {

template <int dim, class Real>
void Threads<dim, Real>::launch(SceneEngine<dim, Real>& scene, const Loop<dim, Real>& loop) const {
    const auto block = [&](int begin, int end) { loop.body(scene, begin, end); };
    loop_blocks(scene.phase(loop.phase).size(), loop.sweep ? search::RunList::smallest_block : 2048, scene.threads,
                Callable<void(int, int)>(block));
}

template <int dim, class Real>
void SceneEngine<dim, Real>::run(const Pass<dim, Real>& pass, double dt, const Bits& chosen) {
    step_length = dt;
    for (const ColumnRange& range : pass.cleared)
        if (chosen.test(range.phase))
            clear(range);
    for (const Loop<dim, Real>& loop : pass.loops)
        if (chosen.test(loop.phase))
            run(loop);
    for (const ColumnRange& range : pass.cleared)
        if (chosen.test(range.phase))
            add_if_implicit(range);
}

template <int dim, class Real>
void SceneEngine<dim, Real>::run_for_grown(const Pass<dim, Real>& pass) {
    Bits concerned;
    for (std::size_t k = 0; k < this->phases.size(); ++k)
        if (this->phases[k].grown)
            concerned.set(static_cast<int>(k));
    for (std::size_t k = 0; k < pass.loops.size(); ++k) // one more in every round
        for (const Loop<dim, Real>& loop : pass.loops)
            for (const int link : loop.links)
                if (concerned.test(this->link_at(link).row.b))
                    concerned.set(loop.phase);
    run(pass, 0, concerned);
    for (Phase& s : this->phases)
        s.grown = false;
}

template <int dim, class Real>
void SceneEngine<dim, Real>::clear(const ColumnRange& range) {
    Phase& s = this->phase(range.phase);
    const auto block = [&](int begin, int end) {
        for (int k = 0; k < range.components; ++k)
            std::fill_n(s.column(range.first + k) + begin, end - begin,
                        range.from_gravity ? static_cast<Real>(this->gravity[k % dim]) : Real(0));
    };
    loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
    s.note_written(range.first);
}

template <int dim, class Real>
void SceneEngine<dim, Real>::add_if_implicit(const ColumnRange& range) {
    Phase& s = this->phase(range.phase);
    if (range.first != s.row->implicit_acceleration || !s.row->moves)
        return;
    const auto block = [&](int begin, int end) {
        for (int k = 0; k < range.components; ++k) {
            const Real* const from = s.column(range.first + k);
            Real* const to = s.column(s.row->acceleration + k);
            for (int i = begin; i < end; ++i)
                to[i] += from[i];
        }
    };
    loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
    s.note_written(s.row->acceleration);
}

template <int dim, class Real>
void SceneEngine<dim, Real>::run(const Loop<dim, Real>& loop) {
    Phase& s = this->phase(loop.phase);
    if (s.size() == 0)
        return;
    if (loop.advances_density)
        keep_volume(s, s.column(s.row->density), step_length, box_of(*this, loop.phase), this->threads);
    if (!loop.sweep || meets_any(loop)) {
        for (int k : loop.links) {
            fetch(this->link_at(k), loop.reads_near);
            ++this->link_at(k).sweeps;
        }
        space->launch(*this, loop);
        for (std::size_t k = 0; k < s.row->fields.size(); ++k)
            if (loop.writes.test(s.row->first_bit + static_cast<int>(k)))
                s.note_written(s.row->fields[k].first);
    }
    s.pad();
}

template <int dim, class Real>
void SceneEngine<dim, Real>::fetch(const Link& link, const Bits& reads) {
    const Phase& b = this->phase(link.row.b);
    if (!b.row->keeps_reference() || link.row.reference || link.runs.is_empty())
        return;
    for (std::size_t k = 0; k < b.row->fields.size(); ++k)
        if (b.row->fields[k].first != b.row->position && reads.test(b.row->first_bit + static_cast<int>(k)))
            this->seen_of(link.row.b).refresh(b, static_cast<int>(k), this->threads);
}

} // namespace imbibe::detail
