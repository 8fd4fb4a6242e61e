// Snapshots of a whole scene: a VTK series for each phase, with every state and every field that is `shown`.
#pragma once

#include <imbibe/core/compiled_core.hpp>
#include <imbibe/output/vtk_series.hpp>
#include <imbibe/solver/scene_store.hpp>

#include <cctype>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace imbibe {

/// Writes `<folder>/<phase>_000000.vtp`, ... and `<folder>/<phase>.pvd` for every phase, with the phase's name in lower
/// case. Used directly as an observer of `run_until` it writes before the first step and after every one;
/// `every(interval, Snapshots(folder))` writes at intervals.
///
/// A folder holds one series, as for VtkSeries: a snapshot replaces those that are not earlier, so a run may go back to
/// a checkpoint. The first snapshot of an object, at a time above 0 s, continues what the folder lists before that
/// time, so a restarted run writes into the folder of the run before; at 0 s a new series begins. A new run whose first
/// snapshot is at a later time calls `resume(scene, 0)` before it, or has a folder of its own.
class Snapshots {
public:
    /// Throws Error now, not at the first snapshot, if the folder cannot be written.
    explicit Snapshots(std::filesystem::path folder) : folder_(std::move(folder)) { require_writable(folder_); }

    /// Writes one snapshot of the present scene. Throws Error as VtkSeries::write does.
    template <class Scene>
    void operator()(const Scene& scene) {
        write(scene.engine(), scene.time(), scene.settings().origin);
    }

    /// The number of snapshots of the phase that has the most.
    std::size_t size() const {
        std::size_t most = 0;
        for (const auto& [name, series] : series_)
            most = std::max(most, series.size());
        return most;
    }
    /// The names of the files in the folder that list the snapshots of a scene, such as `water.pvd`, one for each
    /// phase.
    template <class Scene>
    static std::vector<std::string> lists(const Scene& scene) {
        std::vector<std::string> names;
        for (const auto& phase : scene.engine().phases)
            names.push_back(file_name(scene.engine(), phase) + ".pvd");
        return names;
    }
    /// Continues after the first `snapshots` of an earlier run in the same folder, for any time of the next one; with 0
    /// a new series begins. Throws Error if they are not there.
    template <class Scene>
    void resume(const Scene& scene, std::size_t snapshots) {
        for (const auto& phase : scene.engine().phases)
            series(file_name(scene.engine(), phase)).resume(snapshots);
    }

private:
    std::filesystem::path folder_;
    std::map<std::string, VtkSeries> series_;

    // The phase's name in lower case; with its number if another one has the same.
    template <int dim, class Real>
    static std::string file_name(const detail::SceneStore<dim, Real>& scene,
                                 const detail::PhaseStore<dim, Real>& phase) {
        int same = 0;
        for (const auto& other : scene.phases)
            same += lower_case(other.name) == lower_case(phase.name);
        const auto number = &phase - scene.phases.data() + 1;
        return same > 1 ? text(lower_case(phase.name), "_", number) : lower_case(phase.name);
    }
    static std::string lower_case(std::string name) {
        for (char& c : name)
            c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return name;
    }
    VtkSeries& series(const std::string& name) {
        return series_.try_emplace(name, folder_, name, VtkPrecision::single).first->second;
    }

    template <int dim, class Real>
    void write(const detail::SceneStore<dim, Real>& scene, double seconds, const detail::Origin<dim>& origin);
};

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/output/snapshots_code.hpp>
#endif
