// Runs that return to the last good state and continue with shorter steps when a guard stops them.
#pragma once

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/output/snapshots.hpp>

namespace imbibe {

/// Writes the particles of a failed scene into `folder`, for ParaView, and replaces those of an earlier failure there.
/// Returns a sentence about it, to append to the error message; also if they could not be written.
template <class Scene>
std::string keep_offending_state(const Scene& scene, const std::filesystem::path& folder) {
    try {
        Snapshots snapshots(folder);
        snapshots.resume(scene, 0);
        snapshots(scene);
        return ". The particles as they were: " + folder.string();
    } catch (const Error& error) {
        return std::string(". The particles could not be written: ") + error.what();
    }
}

/// Runs `scene` to `end`, s, under `guard` with a checkpoint every `seconds` of wall time. The guard checks the scene
/// before each is written; the first is written at once, so that a bad initial state is refused. When the guard or the
/// solver stops the run, its particles are written to the folder `<checkpoint>.broken`, for ParaView, and the scene
/// goes back to the last checkpoint and continues with steps half as long, at most `retries` times. Each time, when the
/// scene is back, `returned(error)` is called with the cause and where the failed particles were written. Observers see
/// time go back: `every` calls at once at the time it goes back to, and snapshots and tables over time replace what
/// came after. A scene that reads a later checkpoint of the run keeps the shorter steps.
/// @throws Error (Diverged if the guard stopped it) when the retries are used up, or the initial state is bad; at once
/// for what an observer throws that is not Diverged, or a disk that takes no more checkpoints: shorter steps would not
/// help
template <class Scene, int dim, class Returned, class... Observers>
void run_and_recover(Scene& scene, double end, Guard<dim>& guard, const std::filesystem::path& checkpoint,
                     double seconds, int retries, const Returned& returned, Observers&&... observers) {
    Checkpoints checkpoints(checkpoint, seconds);
    guard.look(scene);
    write_checkpoint(scene, checkpoint);
    bool of_observer = false; // does the error come from an observer, not from a diverged scene?
    const auto watched = [&of_observer](auto& observer) {
        return [&](Scene& s) {
            of_observer = true;
            try {
                observer(s);
            } catch (const Diverged&) {
                of_observer = false;
                throw;
            }
            of_observer = false;
        };
    };
    const auto checkpoint_if_due = [&](Scene& s) {
        checkpoints(
            s, [] { return CheckpointNotes{}; }, [&](const Scene& now) { guard.look(now); });
    };
    // Out of retries: rethrows the error.
    const auto go_back = [&](const auto& error) {
        if (retries-- <= 0)
            throw error;
        const double shortened = 0.5 * scene.shortened();
        try {
            read_checkpoint(scene, checkpoint);
        } catch (const Error& unreadable) {
            throw Error(text(error.what(), "; and the scene cannot go back, because of the ", unreadable.what()));
        }
        scene.shorten_steps(shortened / scene.shortened());
        guard.start_anew();
        returned(error);
    };
    const auto kept = [&] { return keep_offending_state(scene, checkpoint.string() + ".broken"); };
    for (;;)
        try {
            scene.run_until(end, guard, watched(observers)..., watched(checkpoint_if_due));
            return;
        } catch (const Diverged& found) {
            go_back(Diverged(found.what() + kept(), found.cause, found.phase, found.position, found.time, found.steps));
        } catch (const Error& error) {
            if (of_observer)
                throw;
            go_back(Error(error.what() + kept()));
        }
}

} // namespace imbibe
