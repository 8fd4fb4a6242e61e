// Files that are complete or absent, and a check before a run that they can be written.
#pragma once

#include <imbibe/core/compiled_core.hpp>
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

/// Is `a` earlier than `b`, s? Times that differ by a billionth, as by rounding, are the same.
inline bool earlier(double a, double b) {
    return a < b - 1e-9 * std::abs(b);
}

} // namespace detail

/// A file that appears under its name only when it is complete. Everything is written to `<path>.tmp` beside it, and
/// commit() renames that in one step; a reader, or a run that is killed half-way, finds the previous file or the new
/// one, never half of one. Without commit() (an exception, a full disk) the earlier file stays unchanged. commit() is
/// safe against the end of the program, commit_to_disk() also against a power cut.
class AtomicFile {
public:
    /// Opens `<path>.tmp`. Throws Error if that cannot be done.
    explicit AtomicFile(std::filesystem::path path);
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// Appends text.
    AtomicFile& operator<<(std::string_view words) {
        write(words.data(), words.size());
        return *this;
    }
    /// Appends `bytes` bytes. Throws Error when they cannot be written.
    void write(const void* data, std::size_t bytes);

    /// The target of a symbolic link: the link stays, and its target is replaced.
    [[nodiscard]] static std::filesystem::path behind_links(std::filesystem::path path);
    /// The final path of the file; for a link, its target.
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Flushes the buffers and renames the file. Throws Error when the last bytes cannot be written.
    void commit();
    /// The same, but waits until the bytes, and everything written to the file system before (tables or snapshots that
    /// this file depends on), are on the disk, and then the name. @param before called between the two
    template <class F>
    void commit_to_disk(const F& before) {
        out_.close();
        check();
        force(temporary_, Extent::file_system); // errors of other files are reported to those who wrote them
        if (!force(temporary_, Extent::itself))
            refuse();
        before();
        rename();
        force(path_.has_parent_path() ? path_.parent_path() : std::filesystem::path("."), Extent::itself);
    }

private:
    void rename();
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
    // Flushes the system's buffers of a file or folder, or of its whole file system. False if the disk refuses the
    // data; where the system does not offer this, only that guarantee is lost.
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
    [[noreturn]] void refuse() const;

    std::filesystem::path path_, temporary_;
    std::ofstream out_;
    bool committed_ = false;
};

/// Creates `folder` (and its parents) if need be, writes a small file there and removes it again. Call it before a run,
/// so that hours of work are not lost at the first snapshot. Throws Error naming the folder, the cause and the remedy.
void require_writable(const std::filesystem::path& folder);

} // namespace imbibe

#if IMBIBE_READS_CODE
#include <imbibe/output/file_code.hpp>
#endif
