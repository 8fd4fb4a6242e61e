// Runs small scenes of every kind that the library knows and prints a checksum of every column of their particles. A
// change that is to change no bit prints what tests/bits/expected.txt has; a scene on two threads, and one that is
// continued from a checkpoint, print what they print on one thread and in one go.
//
//   test_bits_more                 prints "checksum scene number phase field" for all of them
//   test_bits_more expected.txt    compares with such lines, and ends with 1 where one differs
#include "bits.hpp"

#include <cstdlib>
#include <fstream>

int main(int count, char** words) {
    imbibe_test::Record record;
    try {
        imbibe_test::run_sponges(record);
        imbibe_test::run_water(record);
        imbibe_test::run_solids(record);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bits: %s\n", error.what());
        return 2;
    }
    if (count > 1) {
        imbibe_test::Checksums expected;
        std::ifstream file(words[1]);
        std::string sum, what;
        while (file >> sum && std::getline(file >> std::ws, what))
            expected[what] = std::strtoull(sum.c_str(), nullptr, 16);
        if (expected.empty()) {
            std::fprintf(stderr, "bits: %s has no checksums, or cannot be read\n", words[1]);
            return 2;
        }
        record.compare("expected", record.all, expected);
    } else {
        for (const auto& [what, sum] : record.all)
            std::printf("%016llx %s\n", static_cast<unsigned long long>(sum), what.c_str());
    }
    for (const std::string& fault : record.faults)
        std::fprintf(stderr, "differs: %s\n", fault.c_str());
    std::fprintf(stderr, "%zu columns, %zu differ\n", record.all.size(), record.faults.size());
    return record.faults.empty() ? 0 : 1;
}
