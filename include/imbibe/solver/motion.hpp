// How particles move: velocities by accelerations, positions by velocities, and how fast that is.
#pragma once

#include <imbibe/solver/neighbourhood.hpp>

namespace imbibe::detail {

template <int dim, class Real, class Scene>
class Mover : public Neighbourhood<dim, Real, Scene> {
    using Base = Neighbourhood<dim, Real, Scene>;

public:
    template <class P>
    using FieldsOf = typename Base::template FieldsOf<P>;
    template <class P>
    using State = typename Base::template State<P>;
    using Base::for_each_phase;

    /// velocity += dt * acceleration, for what moves and is not held; measures the motion.
    void kick(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves) {
                const Real by = static_cast<Real>(dt);
                Real* v = s.field(velocity);
                const Real* a = s.field(acceleration);
                const std::size_t stride = s.stride();
                const Motion start;
                this->motions[static_cast<std::size_t>(Scene::template phase_index<P>)] = parallel_reduce(
                    s.size(), this->threads, start,
                    [&](int begin, int end) {
                        Real speed2 = 0, acceleration2 = 0;
                        for (int i = begin; i < end; ++i) {
                            Real free = 1, v2 = 0, a2 = 0;
                            if constexpr (contains<Mobility, FieldsOf<P>>)
                                free = s.field(mobility)[i];
                            for (std::size_t d = 0; d < dim; ++d) {
                                const std::size_t k = d * stride + static_cast<std::size_t>(i);
                                v[k] += by * free * a[k];
                                v2 += v[k] * v[k];
                                a2 += free * a[k] * a[k];
                            }
                            speed2 = std::max(speed2, v2);
                            acceleration2 = std::max(acceleration2, a2);
                        }
                        return Motion{std::sqrt(static_cast<double>(speed2)),
                                      std::sqrt(static_cast<double>(acceleration2))};
                    },
                    [](const Motion& a_, const Motion& b_) {
                        return Motion{std::max(a_.speed, b_.speed), std::max(a_.acceleration, b_.acceleration)};
                    });
            }
        });
    }
    /// position += dt * (velocity + transport correction), for what moves and is not held.
    void drift(double dt) {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            if constexpr (P::moves)
                parallel_blocks(s.size(), 4096, this->threads, [&](int begin, int end) {
                    const Real by = static_cast<Real>(dt);
                    for (int d = 0; d < dim; ++d) {
                        Real* x = s.column(State<P>::template offset<Position> + d);
                        const Real* v = s.column(State<P>::template offset<Velocity> + d);
                        for (int i = begin; i < end; ++i) {
                            Real speed = v[i];
                            if constexpr (contains<TransportCorrection, FieldsOf<P>>)
                                speed += s.column(State<P>::template offset<TransportCorrection> + d)[i];
                            if constexpr (contains<Mobility, FieldsOf<P>>)
                                speed *= s.field(mobility)[i];
                            x[i] += by * speed;
                        }
                    }
                });
        });
    }

    /// Measures the greatest speed of every phase; its acceleration is at least gravity. For the first step.
    void measure_motion() {
        for_each_phase([&]<class P>(std::type_identity<P>, State<P>& s) {
            auto& m = this->motions[static_cast<std::size_t>(Scene::template phase_index<P>)];
            m.acceleration = std::max(m.acceleration, std::sqrt(squared_norm(this->gravity)));
            if constexpr (contains<Velocity, FieldsOf<P>>) {
                double most = 0;
                for (int i = 0; i < s.size(); ++i) {
                    double v2 = 0;
                    for (int d = 0; d < dim; ++d)
                        v2 += sq(static_cast<double>(s.column(State<P>::template offset<Velocity> + d)[i]));
                    most = std::max(most, v2);
                }
                m.speed = std::sqrt(most);
            }
        });
    }
};

} // namespace imbibe::detail
