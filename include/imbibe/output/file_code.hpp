// The code of file.hpp: opens, writes and names files.
#pragma once

#include <imbibe/output/file.hpp>

namespace imbibe {

IMBIBE_CODE AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(behind_links(std::move(path))), temporary_(path_.string() + ".tmp") {
    std::error_code none_there; // a leftover of a killed program under this name may be another name of a good file
    if (!std::filesystem::is_directory(temporary_, none_there))
        std::filesystem::remove(temporary_, none_there);
    out_.open(temporary_, std::ios::binary);
    require(out_.is_open(), "cannot write ", path_.string(),
            ": the file cannot be opened; check that its folder exists and may be written by you");
}

IMBIBE_CODE AtomicFile::~AtomicFile() {
    if (committed_)
        return;
    out_.close();
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
}

IMBIBE_CODE void AtomicFile::write(const void* data, std::size_t bytes) {
    out_.write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    check();
}

IMBIBE_CODE std::filesystem::path AtomicFile::behind_links(std::filesystem::path path) {
    std::error_code unknown;
    if (!std::filesystem::is_symlink(path, unknown))
        return path;
    auto target = std::filesystem::canonical(path, unknown);
    return unknown ? path : target;
}

IMBIBE_CODE void AtomicFile::commit() {
    out_.close();
    check();
    rename();
}

IMBIBE_CODE void AtomicFile::rename() {
    std::error_code error;
    std::filesystem::rename(temporary_, path_, error);
    require(!error, "cannot give ", temporary_.string(), " its name ", path_.string(), ": ", error.message());
    committed_ = true;
}

IMBIBE_CODE void AtomicFile::refuse() const {
    std::error_code error;
    const auto space = std::filesystem::space(path_.has_parent_path() ? path_.parent_path() : ".", error);
    throw Error(text("cannot write ", path_.string(), ": the disk refused it",
                     error ? "" : text(" (", static_cast<double>(space.available) / 1e6, " MB free)"),
                     ". Earlier files are whole; free space there or choose another folder, then continue the run"));
}

IMBIBE_CODE void require_writable(const std::filesystem::path& folder) {
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
