// Runs a case and writes what came of it as rows of a Markdown table, and puts them into a document.
#pragma once

#include "../support/document.hpp"
#include "case.hpp"

#include <cstdio>
#include <ctime>
#include <sstream>

namespace validation {

namespace sph = imbibe;

/// A share as a percentage with two digits that count, or as a power of ten where it is round-off.
inline std::string percentage(double share) {
    char words[32];
    if (std::abs(share) < 1e-6)
        std::snprintf(words, sizeof words, "%.0e", share);
    else
        std::snprintf(words, sizeof words, "%+.*f %%",
                      std::abs(share) < 0.00095  ? 3
                      : std::abs(share) < 0.0095 ? 2
                                                 : 1,
                      100 * share);
    return words;
}

/// The rows of a case: name, quantity, computed (finest), reference, error at each resolution, order, what is good.
inline std::string table_rows(const Case& c) {
    std::vector<std::vector<Measured>> found;
    for (const int n : c.resolutions) {
        const std::clock_t start = std::clock();
        found.push_back(c.run(n));
        std::fprintf(stderr, "%s, %d %s: %.1f s\n", c.name.c_str(), n, c.counts.c_str(),
                     static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    std::ostringstream out;
    for (std::size_t q = 0; q < found.front().size(); ++q) {
        const Measured& finest = found.back()[q];
        out << "| " << c.name << " | " << finest.what << " | " << sph::text(finest.computed) << " | "
            << sph::text(finest.reference) << " | ";
        for (std::size_t r = 0; r < found.size(); ++r)
            out << (r > 0 ? ", " : "") << c.resolutions[r] << ": " << percentage(found[r][q].error());
        // An order says something where the error is more than the reference's last digit and has kept its sign.
        char order[16] = "";
        for (std::size_t r = 1; r < found.size(); ++r) {
            const double coarse = found[r - 1][q].error(), fine = found[r][q].error();
            if (fine * coarse > 0 && std::abs(fine) > 1e-4)
                std::snprintf(order, sizeof order, "%.1f",
                              observed_order(coarse, c.resolutions[r - 1], fine, c.resolutions[r]));
        }
        out << " | " << order << " | " << finest.good << " |\n";
    }
    return out.str();
}

/// Replaces the rows of a case in the table of a document, or adds them at its end. Throws Error if the document cannot
/// be written.
inline void replace_rows(sph::bench::Document& document, const std::string& name, const std::string& rows) {
    std::istringstream in(document.generated());
    std::string line, table;
    bool written = false;
    while (std::getline(in, line)) {
        const bool of_this_case = line.rfind("| " + name + " |", 0) == 0;
        if (of_this_case && !written)
            table += rows;
        written = written || of_this_case;
        if (!of_this_case)
            table += line + "\n";
    }
    document.replace(written ? table : table + rows);
}

} // namespace validation
