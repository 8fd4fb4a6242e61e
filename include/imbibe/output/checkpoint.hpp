// Checkpoints: the complete state of a running scene in one file, from which a run continues bit by bit.
//
//   imbibe::write_checkpoint(scene, "out/checkpoint");            // now and then, or by `imbibe::Checkpoints`
//   imbibe::read_checkpoint(scene, "out/checkpoint");             // in a scene that was built as before
#pragma once

#include <imbibe/output/file.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/material_numbers.hpp>
#include <imbibe/solver/solver.hpp>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <optional>

namespace imbibe {

/// A program's own numbers that a checkpoint carries along: the number of rows of a table, the drained mass.
using CheckpointNotes = std::map<std::string, double>;

namespace detail {

inline constexpr std::string_view checkpoint_title = "imbibe checkpoint 5\n";
inline constexpr std::string_view end_of_checkpoint_head = "----\n";

/// A 64-bit checksum (FNV-1a, Fowler, Noll and Vo).
inline std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t sum = 0xcbf29ce484222325ULL;
    for (const char c : bytes)
        sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    return sum;
}

/// Collects what it is given.
struct CheckpointWriter {
    static constexpr bool reading = false;
    std::string bytes;

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(const T& value) { array(&value, 1); }
    void operator()(const std::string& words) {
        (*this)(std::uint64_t{words.size()});
        bytes += words;
    }
    template <class T>
    void array(const T* values, std::size_t count) {
        bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
    }
};

/// Returns the same data in the same order.
struct CheckpointReader {
    static constexpr bool reading = true;
    std::string_view bytes;
    std::string where; ///< the file, for messages

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void operator()(T& value) { array(&value, 1); }
    void operator()(std::string& words) {
        std::uint64_t size = 0;
        (*this)(size);
        need(size, 1);
        words.assign(bytes.substr(0, size));
        bytes.remove_prefix(size);
    }
    template <class T>
    void array(T* values, std::size_t count) {
        need(count, sizeof(T));
        if (count == 0)
            return;
        std::memcpy(values, bytes.data(), count * sizeof(T));
        bytes.remove_prefix(count * sizeof(T));
    }
    /// Skips what array() would read.
    void skip(std::uint64_t count, std::uint64_t size_of_each) {
        need(count, size_of_each);
        bytes.remove_prefix(count * size_of_each);
    }
    void need(std::uint64_t count, std::uint64_t size_of_each) const {
        require(count <= bytes.size() / size_of_each, "checkpoint ", where,
                ": it is shorter than it says; take the one before it");
    }
};

/// What must agree between the scene that wrote a checkpoint and the one that reads it, as lines of text.
template <class Scene>
std::string checkpoint_head(const Scene& scene) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << checkpoint_title << "numbers " << 8 * sizeof(typename Scene::Real) << " bits, "
        << (std::endian::native == std::endian::little ? "little" : "big") << " end first\ndimension "
        << Scene::dimension << '\n';
    scene.engine().for_each_phase([&]<class P, class S>(std::type_identity<P>, const S& s) {
        const std::string name_of_phase = name_among<P>(typename Scene::Phases{});
        out << "phase " << name_of_phase << ": density " << s.material.density << " kg/m^3, spacing "
            << s.material.spacing << " m, support radius " << s.material.support_radius << " m, fields";
        const auto name = [&]<class... F>(TypeList<F...>) {
            ((out << ' ' << F::name << '(' << components(F::rank, Scene::dimension) << ')'), ...);
        };
        name(typename Scene::template FieldsOf<P>{});
        out << "\nterms of " << name_of_phase << ": " << names_of(typename P::terms{}) << '\n';
    });
    const auto name_couplings = [&]<class... C>(TypeList<C...>) {
        ((out << "terms of " << type_name<C>() << ": " << names_of(typename C::terms{}) << '\n'), ...);
    };
    name_couplings(typename Scene::Couplings{});
    out << "integrator " << names_of(TypeList<typename Scene::Integrator>{}) << '\n';
    for (std::size_t d = 0; d < Scene::dimension; ++d)
        out << "direction " << d << ": origin " << scene.settings().origin[d] << " m, periodic from "
            << scene.settings().periodic_lower[d] << " m over " << scene.settings().periodic_length[d] << " m\n";
    out << end_of_checkpoint_head;
    return out.str();
}

/// The numbers that may differ in the scene that reads a checkpoint, as lines of text: those of materials and
/// couplings.
template <class Scene>
std::string checkpoint_numbers(const Scene& scene) {
    std::string lines;
    const auto add = [&](const std::string& name, const NamedNumbers& numbers) {
        for (const auto& [what, number] : numbers)
            lines += text(name, ": ", what, " = ", number, "\n");
    };
    scene.engine().for_each_phase([&]<class P>(std::type_identity<P>, const auto& s) {
        add(name_among<P>(typename Scene::Phases{}), numbers_of_owner(s.material));
    });
    const auto add_couplings = [&]<class... C>([[maybe_unused]] TypeList<C...> all) {
        (add(name_among<C>(all), numbers_of_owner(scene.template coupling<C>())), ...);
    };
    add_couplings(typename Scene::Couplings{});
    return lines;
}
/// A sentence about how these lines differ from those of a checkpoint; empty if they do not.
inline std::string warning_of_other_numbers(const std::string& theirs, const std::string& ours,
                                            const std::string& path) {
    std::istringstream lines_there(theirs), lines_here(ours);
    std::string there, here, differences;
    while (std::getline(lines_there, there) && std::getline(lines_here, here))
        if (there != here)
            differences += text(differences.empty() ? "" : "; ", there, " there, ",
                                here.substr(std::min(here.size(), here.find(" = ") + 3)), " here");
    if (differences.empty())
        return {};
    return text("checkpoint ", path, ": it was written with other numbers than this scene has, and the run goes on ",
                "with this scene's: ", differences);
}

/// The positions of particles that stay where they were added: those of walls, and the stress-free positions of
/// total-Lagrangian solids. By phase, and by the number a particle had when it was added.
inline std::vector<std::vector<Coordinates>> places_that_stay(const OutlineOfScene& scene) {
    std::vector<std::vector<Coordinates>> all;
    for (const Outline& phase : scene.phases) {
        std::vector<std::pair<std::uint32_t, Coordinates>> by_number;
        if (phase.kind == Kind::wall || phase.at_rest.x != phase.now.x)
            for (int i = 0; i < phase.size(); ++i)
                by_number.emplace_back(phase.ids[i], phase.at_rest.at(i));
        std::sort(by_number.begin(), by_number.end());
        auto& places = all.emplace_back();
        for (const auto& [number, place] : by_number)
            places.push_back(place);
    }
    return all;
}
/// A sentence if a phase of the scene differs from that in a checkpoint, by number of particles or shape; else empty. A
/// phase that a program has moved as a whole is the same.
inline std::string warning_of_other_body(const std::string& name, const std::vector<Coordinates>& here,
                                         const std::vector<Coordinates>& there, double spacing,
                                         const std::string& path) {
    if (here.empty() || there.empty()) // nothing was added before the checkpoint was read
        return {};
    const char* const goes_on = "; the run goes on with the checkpoint's. Build the scene as it was";
    if (here.size() != there.size())
        return text("checkpoint ", path, ": ", name, " has ", there.size(), " particles there and ", here.size(),
                    " in this scene", goes_on);
    double farthest = 0; // along an axis, beyond the common displacement
    for (std::size_t d = 0; d < 3; ++d) {
        double moved = 0;
        for (std::size_t i = 0; i < here.size(); ++i)
            moved += (there[i][d] - here[i][d]) / static_cast<double>(here.size());
        for (std::size_t i = 0; i < here.size(); ++i)
            farthest = std::max(farthest, std::abs(there[i][d] - here[i][d] - moved));
    }
    if (farthest < 1e-2 * spacing)
        return {};
    return text("checkpoint ", path, ": ", name, " has another shape there than in this scene, by up to ", farthest,
                " m (", farthest / spacing, " spacings)", goes_on);
}

/// The text of a long line around its first difference to another: "terms of Water: ... Diffusion<WendlandC4> ...".
/// @param same how many characters the two have in common at the beginning
inline std::string around_difference(const std::string& line, std::size_t same) {
    constexpr std::size_t most = 120, before = 60;
    if (line.size() <= most)
        return line;
    std::size_t begin = same > before ? same - before : 0;
    if (const auto word = line.find(' ', begin); begin > 0 && word < same)
        begin = word + 1;
    const auto label = line.find(": ");
    const std::string start = begin == 0 ? "" : label < begin ? line.substr(0, label + 2) + "... " : "... ";
    return start + line.substr(begin, most) + (line.size() > begin + most ? " ..." : "");
}

/// The first line in which two texts differ, of each.
inline std::pair<std::string, std::string> first_difference(const std::string& a, const std::string& b) {
    std::istringstream lines_a(a), lines_b(b);
    std::string line_a, line_b;
    for (;;) {
        const bool more_a = static_cast<bool>(std::getline(lines_a, line_a));
        const bool more_b = static_cast<bool>(std::getline(lines_b, line_b));
        if (!more_a && !more_b)
            return {};
        if (more_a && more_b && line_a != line_b) {
            const auto parted = std::mismatch(line_a.begin(), line_a.end(), line_b.begin(), line_b.end()).first;
            const auto same = static_cast<std::size_t>(parted - line_a.begin());
            return {around_difference(line_a, same), around_difference(line_b, same)};
        }
        if (!more_a || !more_b)
            return {more_a ? line_a : "nothing", more_b ? line_b : "nothing"};
    }
}

/// The suffix of a second name while it is being made.
inline constexpr const char* link_ending = ".link";

/// Refuses a name that leaves no room for the previous checkpoint's: file systems allow names of 255 bytes.
inline void require_short_name(const std::filesystem::path& path) {
    constexpr std::size_t most = 255 - std::string_view(".previous").size() - std::string_view(link_ending).size();
    const auto name = path.filename().string();
    require(name.size() <= most, "the checkpoint's name ", name, " has ", name.size(), " bytes; it may have at most ",
            most, ", so that the one before it can be kept under a longer one. Give it a shorter name");
}

/// Gives an existing checkpoint a second name, or makes a copy if the file system has no hard links. The former file of
/// that name stays until then. Throws Error, `hence` in it, if that fails: there would be nothing to fall back on.
inline void give_second_name(const std::filesystem::path& checkpoint, const std::filesystem::path& second,
                             const char* hence) {
    std::error_code error;
    if (!std::filesystem::exists(checkpoint, error))
        return;
    const std::filesystem::path fresh = second.string() + link_ending;
    std::filesystem::remove(fresh, error); // left by a program that was killed here
    std::filesystem::create_hard_link(checkpoint, fresh, error);
    if (error) {
        error.clear();
        std::filesystem::copy_file(checkpoint, fresh, error);
    }
    if (!error)
        std::filesystem::rename(fresh, second, error);
    if (error) {
        std::error_code ignored;
        std::filesystem::remove(fresh, ignored);
        throw Error(text("cannot keep the checkpoint ", checkpoint.string(), " as ", second.string(), ": ",
                         error.message(), "; it stays, and ", hence, ". Free space there, or move away what has ",
                         "that name, then continue the run"));
    }
    std::filesystem::remove(fresh, error); // is still there if both names were of one file already
}

/// A complete checkpoint, from its title to its checksum.
template <class Scene>
std::string checkpoint_bytes(Scene& scene, const CheckpointNotes& notes = {}) {
    CheckpointWriter state;
    state.bytes = checkpoint_head(scene);
    state(checkpoint_numbers(scene));
    state(std::uint64_t{notes.size()});
    for (const auto& [name, value] : notes) {
        state(name);
        state(value);
    }
    scene.archive(state);
    state(checksum(state.bytes));
    return std::move(state.bytes);
}

} // namespace detail

/// Makes the checkpoint at `path` `<path>.previous` as well. For a run that continues from the previous checkpoint:
/// call it after reading that, and before dropping later data from tables and snapshots. The later checkpoint does not
/// fit them then, and a run killed before its next checkpoint would be left with it. Does nothing if there is no
/// previous one.
/// @param path the file of the later one
/// @throws Error when the disk refuses it
inline void return_to_previous_checkpoint(const std::filesystem::path& path) {
    detail::give_second_name(path.string() + ".previous", AtomicFile::behind_links(path), "so does the later one");
}

/// Writes the state of a scene to `path`: every field of every particle, their order and numbers, time, step count and
/// whatever the next time step depends on. An earlier checkpoint is kept as `<path>.previous`.
///
/// The file is written beside its place, forced to the disk and then renamed in one step: there is a complete
/// checkpoint whenever the program ends. Tables and snapshots written to the same file system before it are forced to
/// the disk first, so that after a power cut they are not older than it. It begins with a readable description of the
/// scene and ends with a checksum.
///
/// The run that goes on and one that is continued from the file both sort their particles here (views become invalid)
/// and find neighbours anew at the next step, and stay the same to the last bit. A run without checkpoints is the same
/// only if that step would have found neighbours anyway (Solver::search_is_due): always, unless
/// Settings::search_interval is above 1; Checkpoints waits for such a step. With integrators that move particles before
/// they find neighbours, PositionVerlet and, with such an interval, Leapfrog, it differs in the last digits.
/// @param scene the scene to write
/// @param path the file
/// @param notes the program's own numbers to store
/// @throws Error when the disk refuses it, when a coordinate is not a finite number, or for a name of more than 241
///     bytes; the earlier checkpoints stay
template <class Scene>
void write_checkpoint(Scene& scene, const std::filesystem::path& path, const CheckpointNotes& notes = {}) {
    detail::require_short_name(path);
    scene.prepare();
    scene.require_finite("nothing is written to " + path.string() + ", what is there stays: ");
    const std::string bytes = detail::checkpoint_bytes(scene, notes);

    AtomicFile file(path);
    file.write(bytes.data(), bytes.size());
    file.commit_to_disk(
        [&] { detail::give_second_name(file.path(), path.string() + ".previous", "no new one is written"); });
}

namespace detail {

/// Brings a scene to the state in the bytes of a checkpoint; see read_checkpoint. `path`: for messages.
template <class Scene>
CheckpointNotes restore(Scene& scene, const std::string& all, const std::string& path) {
    require(all.starts_with(checkpoint_title), "checkpoint ", path,
            ": it does not begin as a checkpoint of this version does (", checkpoint_title.substr(0, 19), ")");
    std::uint64_t stored = 0;
    require(all.size() >= checkpoint_title.size() + sizeof stored, "checkpoint ", path,
            ": it is cut off; take the one before it, ", path, ".previous");
    const std::string_view content(all.data(), all.size() - sizeof stored);
    std::memcpy(&stored, content.data() + content.size(), sizeof stored);
    require(stored == checksum(content), "checkpoint ", path,
            ": its checksum is wrong, so it is cut off or damaged; take the one before it, ", path, ".previous");

    const std::string head = checkpoint_head(scene);
    const auto end = content.find(end_of_checkpoint_head);
    const std::string found(content.substr(0, end == std::string_view::npos ? 0 : end + end_of_checkpoint_head.size()));
    const auto [theirs, ours] = first_difference(found, head);
    require(found == head, "checkpoint ", path, ": it is of another scene. It says '", theirs,
            "' where this scene has '", ours, "'");

    CheckpointReader state{content.substr(found.size()), path};
    std::string numbers;
    state(numbers);
    CheckpointNotes notes;
    std::uint64_t count = 0;
    state(count);
    for (std::uint64_t k = 0; k < count; ++k) {
        std::string name;
        double value = 0;
        state(name);
        state(value);
        notes[name] = value;
    }
    const bool is_new = scene.steps() == 0; // else the program may have moved its walls
    const auto here = places_that_stay(scene.outline());
    scene.archive(state);
    scene.warn(warning_of_other_numbers(numbers, checkpoint_numbers(scene), path));
    const OutlineOfScene outline = scene.outline();
    const auto there = places_that_stay(outline);
    for (std::size_t k = 0; k < there.size() && is_new; ++k)
        scene.warn(warning_of_other_body(outline.phases[k].name, here[k], there[k], outline.phases[k].spacing, path));
    return notes;
}

} // namespace detail

/// Brings a scene to the state in a checkpoint. The scene must be made as for the run that wrote it: the same
/// composition, number type, densities, spacings, supports, origin and periods, with its phases added; their numbers of
/// particles do not matter. Other numbers of materials, coefficients and settings are those of this scene: a warning
/// says how materials and coefficients differ, and which walls, or stress-free positions of a solid, differ from those
/// added to this scene. Only the factor of Solver::shorten_steps is the file's, and it multiplies a newly given CFL
/// number. The run then continues bit by bit as if it had not stopped.
/// @return the program's own numbers
/// @throws Error, with the scene as it was, for a file that is missing, cut off, damaged, or of another scene; it names
/// the difference
template <class Scene>
CheckpointNotes read_checkpoint(Scene& scene, const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::error_code unknown;
    if (!in.is_open() || std::filesystem::is_directory(path, unknown))
        throw Error(text("checkpoint ", path.string(), ": there is no such file, or it may not be read",
                         std::filesystem::exists(path.string() + ".previous", unknown)
                             ? "; the one before it is there, with the ending .previous"
                             : ""));
    const std::string all{std::istreambuf_iterator<char>(in), {}};
    return detail::restore(scene, all, path.string());
}

/// An observer for `run_until` that writes a checkpoint at intervals of wall time, or of simulated time. If
/// Settings::search_interval is above 1, it waits for the next step that searches: so checkpoints do not change a bit
/// of the run.
class Checkpoints {
public:
    /// @param path the file to write
    /// @param seconds of wall time between two checkpoints
    /// @param simulated time between two, s: one is due at every multiple of it, too; infinite: by wall time only
    /// @throws Error now if the folder cannot be written, for an interval out of range, or for a name of more than 241
    ///     bytes
    Checkpoints(std::filesystem::path path, double seconds, double simulated = std::numeric_limits<double>::infinity())
        : path_(std::move(path)), seconds_(seconds), simulated_(simulated) {
        require(std::isfinite(seconds) && seconds >= 0, "seconds between checkpoints = ", seconds,
                "; it must be a finite number not below 0");
        require(simulated > 0, "simulated time between checkpoints = ", simulated, " s; it must be above 0 s");
        detail::require_short_name(path_);
        require_writable(path_.has_parent_path() ? path_.parent_path() : std::filesystem::path("."));
    }
    /// Will one be written now?
    template <class Scene>
    bool due(const Scene& scene) const {
        return (std::chrono::duration<double>(Clock::now() - written_).count() >= seconds_ ||
                multiple(scene.time()) > multiple(written_at_.value_or(scene.time()))) &&
               scene.search_is_due();
    }
    /// Writes one if it is due.
    template <class Scene>
    void operator()(Scene& scene) {
        (*this)(scene, [] { return CheckpointNotes{}; });
    }
    /// The same with the program's own numbers, which `notes()` returns, and with a check of the scene: `look(scene)`
    /// is called before a checkpoint is written, and throws if the state is bad (`Guard::look`). True if one was
    /// written.
    template <class Scene, class Notes, class Look>
    bool operator()(Scene& scene, const Notes& notes, const Look& look) {
        const bool now = due(scene);
        if (now) {
            look(scene);
            write_checkpoint(scene, path_, notes());
            written_ = Clock::now();
        }
        if (now || !written_at_ || scene.time() < *written_at_) // the scene may have gone back
            written_at_ = scene.time();
        return now;
    }
    /// The same without a check.
    template <class Scene, class Notes>
    bool operator()(Scene& scene, const Notes& notes) {
        return (*this)(scene, notes, [](const Scene&) {});
    }

private:
    using Clock = std::chrono::steady_clock;
    double multiple(double time) const { return std::floor(time / simulated_ * (1 + 1e-9)); }

    std::filesystem::path path_;
    double seconds_, simulated_;
    Clock::time_point written_ = Clock::now();
    std::optional<double> written_at_; ///< simulated time, s; until one is written that of the first call
};

} // namespace imbibe
