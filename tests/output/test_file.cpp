// Files appear as a whole or not at all, and a folder that cannot be written is found out before the run.
#include "folder.hpp"
#include "full_disk.hpp"

#include <catch_shim.hpp>
#include <imbibe/output/file.hpp>

#include <iostream>
#include <sys/wait.h>
#include <unistd.h>

namespace file_test {

using namespace imbibe;
using imbibe_test::contains;
using output_test::content;
using output_test::fresh;

TEST_CASE("a file gets its name when it is complete", "[output]") {
    const auto path = fresh("atomic") / "words.txt";
    {
        AtomicFile file(path);
        file << "first";
        CHECK_FALSE(std::filesystem::exists(path));
        file.commit();
    }
    CHECK(content(path) == "first");
    {
        AtomicFile file(path);
        file << "second, but never finished";
    }
    CHECK(content(path) == "first");
    AtomicFile file(path);
    file << "third";
    file.commit();
    CHECK(content(path) == "third");
    CHECK(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}) == 1);
}

TEST_CASE("a full disk is an error that leaves the earlier file", "[output]") {
    const auto path = fresh("full") / "words.txt";
    {
        AtomicFile file(path);
        file << "earlier";
        file.commit();
    }
    {
        const output_test::FullDisk full(64 * 1024);
        const std::string much(1 << 20, 'x');
        const auto write = [&] {
            AtomicFile file(path);
            file << much;
            file.commit();
        };
        REQUIRE_THROWS_WITH(write(), contains("words.txt") && contains("the disk refused it"));
    }
    {
        const output_test::FullDisk full(1);
        const auto write = [&] {
            AtomicFile file(path);
            file << "short enough to stay in the buffer until the end";
            file.commit();
        };
        REQUIRE_THROWS_WITH(write(), contains("the disk refused it"));
    }
    CHECK(content(path) == "earlier");
    CHECK(std::distance(std::filesystem::directory_iterator(path.parent_path()), {}) == 1);
}

TEST_CASE("a folder is made, or refused before the run", "[output]") {
    const auto top = fresh("folders");
    require_writable(top / "a" / "b");
    CHECK(std::filesystem::is_empty(top / "a" / "b"));
    CHECK_NOTHROW(require_writable(top / "a" / "b"));

    std::ofstream(top / "file") << "in the way";
    REQUIRE_THROWS_WITH(require_writable(top / "file"),
                        contains((top / "file").string()) && contains("choose another output folder"));
    REQUIRE_THROWS_WITH(require_writable(top / "file" / "below"), contains("choose another output folder"));
    REQUIRE_THROWS_WITH(require_writable(""), contains("has no name"));
    REQUIRE_THROWS_WITH(require_writable(top / std::string(300, 'x')), contains("choose another output folder"));
    std::filesystem::create_symlink("loop", top / "loop");
    REQUIRE_THROWS_WITH(require_writable(top / "loop"), contains("choose another output folder"));
    {
        const output_test::FullDisk full(1);
        REQUIRE_THROWS_WITH(require_writable(top / "a"), contains("4 kB") && contains((top / "a").string()));
    }
    CHECK(std::distance(std::filesystem::directory_iterator(top / "a"), {}) == 1);
}

TEST_CASE("a file behind a link is written where it is", "[output]") {
    const auto top = fresh("links");
    std::filesystem::create_directories(top / "other_disk");
    std::ofstream(top / "other_disk/data") << "old";
    std::filesystem::create_symlink("other_disk/data", top / "data");
    AtomicFile file(top / "data");
    file << "new";
    file.commit();
    CHECK(std::filesystem::is_symlink(top / "data"));
    CHECK(content(top / "other_disk/data") == "new");
}

TEST_CASE("an error that ends the program takes nothing along that was printed before", "[output]") {
    const auto path = fresh("printed") / "stdout.txt";
    std::cout.flush();
    std::fflush(stdout);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) { // ends without emptying a buffer, as std::terminate does
        if (std::freopen(path.c_str(), "w", stdout) == nullptr)
            ::_exit(1);
        std::printf("50 %% done\n");
        try {
            require(false, "something is wrong");
        } catch (const Error&) {
            ::_exit(0);
        }
    }
    int status = -1;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(status == 0);
    CHECK(content(path) == "50 % done\n");
}

} // namespace file_test
