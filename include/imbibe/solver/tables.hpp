// A scene as plain data: its phases, couplings, neighbour links, and the passes that evaluate its terms. lowering.hpp
// makes these tables from the types of a scene, once. The code that runs a scene reads them and is ordinary code; only
// the bodies of its loops (loop_bodies.hpp) are templates of the scene.
#pragma once

#include <imbibe/core/build_options.hpp>
#include <imbibe/core/field.hpp>
#include <imbibe/core/term.hpp>
#include <imbibe/solver/schedule.hpp>

#include <any>
#include <span>
#include <string>
#include <string_view>

namespace imbibe::detail {

/// A field of a phase: one column of numbers per component.
struct FieldRow {
    std::string_view name, unit;
    Rank rank = Rank::scalar;
    bool shown = false;    ///< in snapshots: a state, or a field that is `shown`
    int first = 0;         ///< its first column
    int components = 0;    ///< how many columns
    bool is_state = false; ///< given or integrated
};

/// A state that a step advances by its rate.
struct StateRow {
    int first = 0, rate = 0; ///< the first columns of the state and of its rate
    int components = 0;
    bool is_density = false;
};

/// Numbers of a phase's material for running a scene with any terms.
struct PhaseNumbers {
    double support_radius = 0, spacing = 0; ///< m
    double sound_speed = 0;                 ///< m/s; 0 for a wall
    double density = 0;                     ///< reference density, kg/m^3
};

/// A phase. Columns are -1 where a field is not stored.
struct PhaseRow {
    std::string (*name)() = nullptr; ///< among all phases of the scene
    std::span<const FieldRow> fields;
    std::span<const StateRow> states;
    int components = 0; ///< how many columns it has
    int first_bit = 0;  ///< its fields are the bits from here on in the sets of a loop
    bool moves = false;  ///< moved by forces?
    bool drifts = false; ///< are its positions advanced by its velocity?
    bool fluid = false;
    int position = -1, reference_position = -1, velocity = -1, acceleration = -1, mass = -1;
    int density = -1, density_rate = -1, mobility = -1, transport_correction = -1, supported_share = -1;
    int implicit_acceleration = -1, porosity = -1;
    std::any (*material)() = nullptr; ///< one without numbers yet
    PhaseNumbers (*numbers)(const std::any& material) = nullptr;

    /// The field that begins at a column.
    const FieldRow& field_at(int column) const {
        for (const FieldRow& field : fields)
            if (field.first == column)
                return field;
        return fields.front();
    }
    /// Does it stay in the order of its stress-free configuration, so that others see a sorted copy?
    constexpr bool keeps_reference() const { return reference_position >= 0; }
};

/// A coupling of two phases.
struct CouplingRow {
    std::string (*name)() = nullptr; ///< among all couplings of the scene
    int first = 0, second = 0;       ///< its phases
    bool overlaps = false;           ///< may the two overlap?
    bool asks_for_nearest = false;   ///< for the distance of their nearest particles: it has a repulsion
    /// Is the first phase, or the second, a fluid that is pushed by pressure, and whose density, which follows from its
    /// motion, does not count the other?
    bool first_counts_no_second = false, second_counts_no_first = false;
    std::any (*coupling)() = nullptr; ///< one with default coefficients
};

/// The kind of a limit on the time step.
enum class LimitKind { of_phase, of_coupling, of_acceleration, of_advection };

/// A limit on the time step: of a term of a phase or a coupling, or of no term.
struct LimitRow {
    LimitKind kind = LimitKind::of_phase;
    int phase = 0, other = -1, coupling = -1; ///< both phases of a coupling
    const char* reason = nullptr;
    /// The term's limit, s; below 0 or infinite: none. @param owner has its coefficients
    double (*seconds)(const std::any& owner, const std::any& material, const std::any& other,
                      const TimeStepInput& in) = nullptr;
    int greatest = -1, least = -1; ///< the reductions of the scene that the term uses
    bool of_substeps = false;      ///< does it limit the short steps of a step?
};

/// Phase `a` sums over neighbours in phase `b`: present ones, or those of the stress-free configuration.
struct LinkRow {
    int a = 0, b = 0;
    bool reference = false;
    /// The support radius of a term with its own, m, for which these neighbours are; null for those of all other terms.
    /// @param owner has its coefficients, @param first and @param second the phases of a coupling
    double (*support_of_term)(const std::any& owner, const std::any& first, const std::any& second) = nullptr;
    std::string (*term)() = nullptr; ///< its name
    int coupling = -1;               ///< its owner; -1: phase `a`
};

/// Some columns of one phase.
struct ColumnRange {
    int phase = 0, first = 0, components = 0;
    bool from_gravity = false; ///< do sums in them start from gravity, or from zero?
};

template <int dim, class Real>
class IMBIBE_PER_BUILD SceneEngine;

/// A loop over the particles of a phase, or over their neighbours.
template <int dim, class Real>
struct Loop {
    bool sweep = false;             ///< over neighbours
    int phase = 0;                  ///< whose particles, and who is written to
    std::span<const int> links{};   ///< a sweep's neighbours
    Bits reads_own{}, reads_near{}; ///< fields that are read of the particle and of its neighbours, places included
    Bits writes{};                  ///< fields that are written
    bool advances_density = false;  ///< by its rate
    /// Computes particles [begin, end).
    void (*body)(SceneEngine<dim, Real>&, int begin, int end) = nullptr;
};

/// A term's reduction over the particles of a phase.
template <int dim, class Real>
class IMBIBE_PER_BUILD PhaseStore;
template <int dim, class Real>
struct Reduction {
    int phase = 0;
    std::string_view quantity, unit;
    double of_none = 0;
    double (*both)(double one, double other) = nullptr; ///< of two sets of particles
    /// Of particles [begin, end).
    double (*body)(const PhaseStore<dim, Real>& phase, int begin, int end) = nullptr;
};

/// What an integrator can run: loops one after the other.
template <int dim, class Real>
struct Pass {
    std::span<const Loop<dim, Real>> loops;
    std::span<const ColumnRange> cleared; ///< before the first loop
    std::span<const ColumnRange> kept;    ///< sums of another pass that it adds to
};

/// The part of a scene that does not depend on how steps are made.
struct SceneTable {
    std::span<const PhaseRow> phases;
    std::span<const CouplingRow> couplings;
    std::span<const LinkRow> links;
};

} // namespace imbibe::detail
