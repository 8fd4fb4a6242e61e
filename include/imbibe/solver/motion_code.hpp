// The code of motion.hpp: moves particles.
#pragma once

#include <imbibe/solver/motion.hpp>

namespace imbibe::detail {

template <int dim, class Real>
void Mover<dim, Real>::kick(double dt, const Bits& chosen) {
    for (std::size_t k = 0; k < phases.size(); ++k)
        if (Phase& s = phases[k]; s.row->moves && chosen.test(static_cast<int>(k)))
            s.motion = advance_velocities(s, s.column(s.row->velocity), dt);
}

template <int dim, class Real>
void Mover<dim, Real>::drift(double dt, const Bits& chosen) {
    for (std::size_t k = 0; k < phases.size(); ++k)
        if (Phase& s = phases[k]; s.row->drifts && chosen.test(static_cast<int>(k))) {
            advance_positions(s, s.column(s.row->position), dt);
            note_way(s, dt);
        }
}

template <int dim, class Real>
void Mover<dim, Real>::remember() {
    for (Phase& s : phases) {
        Real* to = nullptr;
        const auto copy = [&](int first, int components) {
            for (int k = first; k < first + components; ++k, to += s.stride())
                copy_column(s.column(k), to, s.size());
        };
        s.remembered.resize(s.stride() * columns_remembered(s));
        to = s.remembered.data();
        if (s.row->drifts)
            copy(s.row->position, dim);
        if (s.row->moves)
            copy(s.row->velocity, dim);
        for (const StateRow& state : s.row->states)
            copy(state.first, state.components);
    }
}

template <int dim, class Real>
void Mover<dim, Real>::advance_remembered(double dt) {
    for (std::size_t k = 0; k < phases.size(); ++k) {
        Phase& s = phases[k];
        const Real* old = s.remembered.data();
        if (s.row->drifts) { // positions first: they need the old velocities
            advance_positions(s, old, dt);
            note_way(s, dt);
            old += dim * s.stride();
        }
        if (s.row->moves) {
            s.motion = advance_velocities(s, old, dt);
            old += dim * s.stride();
        }
        for (const StateRow& state : s.row->states) {
            if (state.is_density)
                keep_volume(s, old, dt, box_of(*this, static_cast<int>(k)), this->threads);
            for (int c = 0; c < state.components; ++c, old += s.stride())
                advance_state(s, state.first + c, old, state.rate + c, dt);
        }
        for (const StateRow& state : s.row->states)
            s.note_written(state.first);
        s.pad();
        this->refresh_seen_places(static_cast<int>(k));
    }
}

template <int dim, class Real>
void Mover<dim, Real>::add_velocities(const Phase& s, Real* to, double by) const {
    const Real* const v = s.column(s.row->velocity);
    const Real* const correction = s.column_if(s.row->transport_correction);
    const Real* const free = s.column_if(s.row->mobility);
    for (std::size_t d = 0; d < dim; ++d)
        for (int i = 0; i < s.size(); ++i) {
            const std::size_t k = d * s.stride() + static_cast<std::size_t>(i);
            Real speed = v[k];
            if (correction)
                speed += (free ? free[i] : Real(1)) * correction[k];
            to[k] += static_cast<Real>(by) * speed;
        }
}

template <int dim, class Real>
void Mover<dim, Real>::keep_sums(std::span<const ColumnRange> columns) {
    for_each_kept(columns, [&](Phase& s, int column, std::size_t at) {
        s.kept_sums.resize(std::max(s.kept_sums.size(), (at + 1) * s.stride()));
        copy_column(s.column(column), s.kept_sums.data() + at * s.stride(), s.size());
    });
}

template <int dim, class Real>
void Mover<dim, Real>::restore_sums(std::span<const ColumnRange> columns) {
    for_each_kept(columns, [&](Phase& s, int column, std::size_t at) {
        copy_column(s.kept_sums.data() + at * s.stride(), s.column(column), s.size());
    });
    for (const ColumnRange& range : columns)
        this->phase(range.phase).note_written(range.first);
}

template <int dim, class Real>
void Mover<dim, Real>::measure_motion() {
    const auto measure_all = [&] {
        for (Phase& s : phases) {
            const double acceleration = std::max(s.motion.acceleration, std::sqrt(squared_norm(this->gravity)));
            s.motion = this->velocities_of(s);
            s.motion.acceleration = acceleration;
        }
    };
    measure_all(); // the means, which define the frame
    this->choose_frame();
    measure_all();
}

template <int dim, class Real>
void Mover<dim, Real>::notice_greater_speeds() {
    for (Phase& s : phases) {
        if (!s.row->moves)
            continue;
        Motion& m = s.motion;
        const Motion now = this->velocities_of(s);
        if (now.speed > m.speed + 1e-5 * m.fastest || now.fastest > m.fastest * (1 + 1e-5)) {
            m.speed = now.speed;
            m.fastest = now.fastest;
            m.mean = now.mean;
        }
    }
}

template <int dim, class Real>
void Mover<dim, Real>::advance_state(Phase& s, int column, const Real* old, int rate_column, double dt) const {
    const Real by = static_cast<Real>(dt);
    Real* const to = s.column(column);
    const Real* const rate = s.column(rate_column);
    const auto block = [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            to[i] = old[i] + by * rate[i];
    };
    loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
}

template <int dim, class Real>
Motion Mover<dim, Real>::advance_velocities(Phase& s, const Real* old, double dt) const {
    s.note_written(s.row->velocity);
    s.note_written(s.row->supported_share);
    const bool held = s.row->mobility >= 0, borne = s.row->supported_share >= 0;
    return held    ? borne ? advance_velocities<true, true>(s, old, dt) : advance_velocities<true, false>(s, old, dt)
              : borne ? advance_velocities<false, true>(s, old, dt)
                   : advance_velocities<false, false>(s, old, dt);
}

template <int dim, class Real>
template <bool has_mobility, bool has_share>
Motion Mover<dim, Real>::advance_velocities(Phase& s, const Real* old, double dt) const {
    const Real by = static_cast<Real>(dt);
    Real* const v = s.column(s.row->velocity);
    const Real* const a = s.column(s.row->acceleration);
    const Real* const mobility = s.column_if(s.row->mobility);
    Real* const share = has_share ? s.column(s.row->supported_share) : nullptr;
    const std::size_t stride = s.stride();
    Real of_frame[static_cast<std::size_t>(dim)];
    for (int d = 0; d < dim; ++d)
        of_frame[d] = static_cast<Real>(this->frame[d]);
    Support<dim, Real> support;
    if constexpr (has_share) {
        const PhaseNumbers numbers = s.numbers();
        support = {this->gravity, dt * numbers.sound_speed / numbers.support_radius};
    }
    const auto block = [&](int begin, int end) {
        Real speed2 = 0, acceleration2 = 0, fastest2 = 0, sum[static_cast<std::size_t>(dim)]{};
        for (int i = begin; i < end; ++i) {
            Real free = 1, v2 = 0, relative2 = 0, a2 = 0, borne = 0;
            if constexpr (has_mobility)
                free = mobility[i];
            for (std::size_t d = 0; d < dim; ++d) {
                const std::size_t k = d * stride + static_cast<std::size_t>(i);
                v[k] = old[k] + by * free * a[k];
                v2 += v[k] * v[k];
                relative2 += sq(v[k] - of_frame[d]);
                sum[d] += v[k];
                a2 += free * a[k] * a[k];
                if constexpr (has_share)
                    borne += support.along(d, free * a[k]);
            }
            if constexpr (has_share)
                share[i] = support.mean(share[i], borne);
            speed2 = std::max(speed2, relative2);
            fastest2 = std::max(fastest2, v2);
            acceleration2 = std::max(acceleration2, a2);
        }
        Motion found{std::sqrt(static_cast<double>(speed2)),
                     std::sqrt(static_cast<double>(acceleration2)),
                     std::sqrt(static_cast<double>(fastest2)),
                     {}};
        for (std::size_t d = 0; d < dim; ++d)
            found.mean[d] = static_cast<double>(sum[d]);
        return found;
    };
    return motion_of_blocks(s.size(), this->threads, Callable<Motion(int, int)>(block));
}

template <int dim, class Real>
void Mover<dim, Real>::advance_positions(Phase& s, const Real* old, double dt) const {
    const Real by = static_cast<Real>(dt);
    const Real* const mobility = s.column_if(s.row->mobility);
    const int correction_column = s.row->transport_correction;
    const auto block = [&](int begin, int end) {
        for (int d = 0; d < dim; ++d) {
            Real* const x = s.column(s.row->position + d);
            const Real* const x0 = old + static_cast<std::size_t>(d) * s.stride();
            const Real* const v = s.column(s.row->velocity + d);
            const Real* const correction = correction_column < 0 ? nullptr : s.column(correction_column + d);
            const auto move = [&](const auto& speed) {
                for (int i = begin; i < end; ++i)
                    x[i] = x0[i] + by * speed(i);
            };
            if (correction && mobility)
                move([&](int i) { return (v[i] + correction[i]) * mobility[i]; });
            else if (correction)
                move([&](int i) { return v[i] + correction[i]; });
            else if (mobility)
                move([&](int i) { return v[i] * mobility[i]; });
            else
                move([&](int i) { return v[i]; });
        }
    };
    loop_blocks(s.size(), 4096, this->threads, Callable<void(int, int)>(block));
}

} // namespace imbibe::detail
