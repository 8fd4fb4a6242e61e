// What runs the loops of a scene: the threads of the processor, or a program's replacement.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/solver/tables.hpp>

namespace imbibe::detail {

/// Runs the bodies of loops. A body touches only what its loop declares (Loop::reads_own, reads_near and writes), and
/// each particle is computed without the others' results: so a space may call it for the particles in any order, and
/// need hold only these columns.
template <int dim, class Real>
class IMBIBE_PER_BUILD Space {
public:
    Space() = default;
    Space(const Space&) = delete;
    Space& operator=(const Space&) = delete;
    virtual ~Space() = default;
    /// Calls the body for all particles of the loop's phase, each once.
    virtual void launch(SceneEngine<dim, Real>& scene, const Loop<dim, Real>& loop) const = 0;
};

/// Distributes the particles over the scene's threads, in blocks.
template <int dim, class Real>
class IMBIBE_PER_BUILD Threads final : public Space<dim, Real> {
public:
    void launch(SceneEngine<dim, Real>& scene, const Loop<dim, Real>& loop) const override;
};

} // namespace imbibe::detail
