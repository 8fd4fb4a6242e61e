// Files that are either there as a whole or not at all, and the check before a run that they can be written.
#pragma once

#include <imbibe/core/error.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#if __has_include(<unistd.h>)
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>
#endif

namespace imbibe {

namespace detail {

/// Is `a` earlier than `b`, s? Times that differ by a billionth, as rounding lets them, are the same.
inline bool earlier(double a, double b) {
    return a < b - 1e-9 * std::abs(b);
}

} // namespace detail

/// A file that appears under its name only when it is complete. Everything is written to `<path>.tmp` beside it, and
/// commit() gives that its name in one step; a reader, or a run that is killed half-way, finds the previous file or
/// the new one, never half of one. Without commit() (an exception, a full disk) the earlier file stays as it was.
/// commit() guards against the end of the program, commit_to_disk() also against that of the power supply.
class AtomicFile {
public:
    /// Opens `<path>.tmp`. Throws Error if that cannot be done.
    explicit AtomicFile(std::filesystem::path path)
        : path_(behind_links(std::move(path))), temporary_(path_.string() + ".tmp") {
        std::error_code none_there; // what a killed program left under this name may be another name of a good file
        if (!std::filesystem::is_directory(temporary_, none_there))
            std::filesystem::remove(temporary_, none_there);
        out_.open(temporary_, std::ios::binary);
        require(out_.is_open(), "cannot write ", path_.string(),
                ": the file cannot be opened; check that its folder exists and may be written by you");
    }
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile() {
        if (committed_)
            return;
        out_.close();
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }

    /// Appends text.
    AtomicFile& operator<<(std::string_view words) {
        write(words.data(), words.size());
        return *this;
    }
    /// Appends `bytes` bytes. Throws Error when they cannot be written.
    void write(const void* data, std::size_t bytes) {
        out_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
        check();
    }

    /// The file that a link stands for: the link stays, and what it names is replaced.
    [[nodiscard]] static std::filesystem::path behind_links(std::filesystem::path path) {
        std::error_code unknown;
        if (!std::filesystem::is_symlink(path, unknown))
            return path;
        auto target = std::filesystem::canonical(path, unknown);
        return unknown ? path : target;
    }
    /// The file that will have its name: where the path is a link, what it stands for.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Empties the buffers and gives the file its name. Throws Error when the last bytes cannot be written.
    void commit() {
        out_.close();
        check();
        rename();
    }
    /// The same, but waits until the bytes are on the disk, with all that was written to its file system before (a
    /// table or snapshots that this file counts on), and then the name. @param before called between the two
    template <class F>
    void commit_to_disk(const F& before) {
        out_.close();
        check();
        force(temporary_, Extent::file_system); // what a disk refused of other files, those who wrote them were told
        if (!force(temporary_, Extent::itself))
            refuse();
        before();
        rename();
        force(path_.has_parent_path() ? path_.parent_path() : std::filesystem::path("."), Extent::itself);
    }

private:
    void rename() {
        std::error_code error;
        std::filesystem::rename(temporary_, path_, error);
        require(!error, "cannot give ", temporary_.string(), " its name ", path_.string(), ": ", error.message());
        committed_ = true;
    }
#if __has_include(<unistd.h>)
    static int sync_file_system([[maybe_unused]] int file_on_it) {
#if defined(__linux__)
        return ::syncfs(file_on_it);
#else
        ::sync();
        return 0;
#endif
    }
#endif
    enum class Extent { itself, file_system };
    // Empties the system's buffers of a file or folder, or of all that is on its file system. False where the disk
    // refuses what is in them; where the system does not offer this, nothing is lost but that guarantee.
    static bool force([[maybe_unused]] const std::filesystem::path& path, [[maybe_unused]] Extent extent) {
#if __has_include(<unistd.h>)
        const int file = ::open(path.c_str(), O_RDONLY);
        if (file >= 0) {
            const bool done = (extent == Extent::itself ? ::fsync(file) : sync_file_system(file)) == 0;
            const bool refused = !done && errno != EINVAL && errno != ENOSYS && errno != ENOTSUP;
            ::close(file);
            return !refused;
        }
#endif
        return true;
    }
    void check() const {
        if (!out_.good())
            refuse();
    }
    [[noreturn]] void refuse() const {
        std::error_code error;
        const auto space = std::filesystem::space(path_.has_parent_path() ? path_.parent_path() : ".", error);
        throw Error(
            text("cannot write ", path_.string(), ": the disk refused it",
                 error ? "" : text(" (", static_cast<double>(space.available) / 1e6, " MB free)"),
                 ". Earlier files are whole; free space there or choose another folder, then continue the run"));
    }

    std::filesystem::path path_, temporary_;
    std::ofstream out_;
    bool committed_ = false;
};

/// Creates `folder` (and those above it) if need be and writes a small file there, which it removes again. To be called
/// before a run, so that hours of work are not lost at the first snapshot. Throws Error naming the folder, the cause
/// and the remedy.
inline void require_writable(const std::filesystem::path& folder) {
    const char* remedy = "; choose another output folder, or change who may write there";
    require(!folder.empty(), "the output folder has no name; choose one, for example \"out\"");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    std::error_code unknown;
    require(std::filesystem::is_directory(folder, unknown), "cannot create the output folder ", folder.string(), ": ",
            error ? error.message() : "something else has that name", remedy);

    const auto trial = folder / ".imbibe_write_test";
    const std::string words(4096, 'x');
    bool written = false;
    {
        std::ofstream out(trial, std::ios::binary);
        out << words;
        out.close();
        written = out.good();
    }
    std::filesystem::remove(trial, error);
    require(written, "cannot write into the output folder ", folder.string(),
            ": a test file of 4 kB could not be written there", remedy);
}

} // namespace imbibe
