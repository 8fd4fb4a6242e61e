// Snapshots of a whole scene: a VTK series for each phase, with every field that is a state or says that it is shown.
#pragma once

#include <imbibe/output/vtk_series.hpp>
#include <imbibe/solver/solver.hpp>

#include <map>

namespace imbibe {

/// Writes `<folder>/<phase>_000000.vtp`, ... and `<folder>/<phase>.pvd` for every phase; the phase's name in lower
/// case. As an observer of `run_until` by itself it writes before the first step and after every one;
/// `every(interval, Snapshots(folder))` writes now and then.
///
/// What is in the folder tells one story, as VtkSeries says: a snapshot replaces those that are not earlier, so a run
/// may go back to a checkpoint; the first of an object, at a time above 0 s, continues what the folder lists before
/// that time, so a restarted run writes into the folder of the run before; and at 0 s a new series begins. A new run
/// whose first snapshot comes later calls `resume(scene, 0)` before it, or has a folder of its own.
class Snapshots {
public:
    /// Throws Error now, not at the first snapshot, if the folder cannot be written.
    explicit Snapshots(std::filesystem::path folder) : folder_(std::move(folder)) { require_writable(folder_); }

    /// One snapshot of the scene as it is. Throws Error as VtkSeries::write does.
    template <class Scene>
    void operator()(const Scene& scene);

    /// How many snapshots there are of the phase that has the most.
    std::size_t size() const {
        std::size_t most = 0;
        for (const auto& [name, series] : series_)
            most = std::max(most, series.size());
        return most;
    }
    /// Goes on behind the first `snapshots` of an earlier run in the same folder, whatever the time of the next one;
    /// with 0 a new series begins. Throws Error if they are not there.
    template <class Scene>
    void resume(const Scene& scene, std::size_t snapshots);

private:
    std::filesystem::path folder_;
    std::map<std::string, VtkSeries> series_;

    template <class Scene, class P>
    static std::string file_name() {
        return detail::name_among<P>(typename Scene::Phases{}, [](std::string name) {
            for (char& c : name)
                c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            return name;
        });
    }
    VtkSeries& series(const std::string& name) {
        return series_.try_emplace(name, folder_, name, VtkPrecision::single).first->second;
    }

    template <class Composition, class P, int dim, class State, class... F>
    void write(const State& s, double seconds, const std::array<double, static_cast<std::size_t>(dim)>& origin,
               TypeList<F...>) {
        VtkFile file(static_cast<std::size_t>(s.size()),
                     VtkArray::of("position", "m", Rank::vector, dim, s.field(position), s.stride()));
        (add<Composition, P, dim, F>(file, s), ...);
        static_assert(sizeof(std::uint32_t) == sizeof(std::int32_t));
        file.add(VtkArray::scalar("id", "1", reinterpret_cast<const std::int32_t*>(s.ids.data())));
        file.constant("spacing", s.material.spacing);
        const char* const names[] = {"origin_x", "origin_y", "origin_z"};
        for (std::size_t d = 0; d < dim; ++d)
            if (origin[d] != 0)
                file.constant(names[d], origin[d]);
        series(file_name<Composition, P>()).write(seconds, std::move(file));
    }
    template <class Composition, class P, int dim, class F, class State>
    static void add(VtkFile& file, const State& s) {
        constexpr bool state = F::given || Composition::template integrated<P, F>();
        if constexpr ((state || F::shown) && !std::is_same_v<F, Position>)
            file.add(VtkArray::of(std::string(F::name), std::string(F::unit), F::rank, dim, s.field(F{}), s.stride()));
    }
};

// Out of the class: a program may leave them to a library (`extern template`).
template <class Scene>
void Snapshots::operator()(const Scene& scene) {
    scene.engine().for_each_phase([&]<class P, class State>(std::type_identity<P>, const State& s) {
        write<typename Scene::Scene, P, Scene::dimension>(s, scene.time(), scene.settings().origin,
                                                          typename Scene::template FieldsOf<P>{});
    });
}
template <class Scene>
void Snapshots::resume(const Scene& scene, std::size_t snapshots) {
    scene.engine().for_each_phase(
        [&]<class P>(std::type_identity<P>, const auto&) { series(file_name<Scene, P>()).resume(snapshots); });
}

} // namespace imbibe
