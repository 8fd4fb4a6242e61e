// Runs that go back to the last good state and go on with shorter steps where a guard stops them.
#pragma once

#include <imbibe/monitor/guard.hpp>
#include <imbibe/output/checkpoint.hpp>
#include <imbibe/output/snapshots.hpp>

namespace imbibe {

/// Writes the particles of a scene that went wrong into `folder`, for ParaView, in place of those of another time that
/// may be there. Returns a sentence about it, to be put behind the message of the error; also where they could not be
/// written.
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

/// Runs `scene` to `end`, s, under `guard` with a checkpoint every `seconds` of wall time, each looked at by the guard
/// before it is written; the first as the scene is now, so that one which is bad already is refused at once. Where the
/// guard, or the solver, stops the run, its particles are written to the folder `<checkpoint>.broken`, for ParaView,
/// and the scene goes back to the last checkpoint and goes on with steps half as long, at most `retries` times;
/// `returned(error)` is told so each time, once the scene is back, and where the particles are that went wrong.
/// Observers see time go back then: `every` calls at once where it goes back to, and snapshots and tables over time
/// replace what came after. A scene that reads a checkpoint of the rest of the run goes on with the shorter steps, too.
/// @throws Error (Diverged, where the guard was the one to stop it) when the retries are used up, or there is nothing
/// good to begin with; at once what an observer throws that is not Diverged, or a disk that takes no more checkpoints:
/// shorter steps would not help
template <class Scene, int dim, class Returned, class... Observers>
void run_and_recover(Scene& scene, double end, Guard<dim>& guard, const std::filesystem::path& checkpoint,
                     double seconds, int retries, const Returned& returned, Observers&&... observers) {
    Checkpoints checkpoints(checkpoint, seconds);
    guard.look(scene);
    write_checkpoint(scene, checkpoint);
    bool of_observer = false; // is the error that is on its way one of an observer, and not that the scene diverged?
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
    // Out of retries: the error goes on, as what it is.
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
