// A document with a part that a program writes, between two lines that stay.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/output/file.hpp>

#include <fstream>
#include <sstream>
#include <string>

namespace imbibe::bench {

/// Read before anything is computed, so that a document that is not what it should be is noticed in time.
class Document {
public:
    /// @param name the lines are `<!-- name: begin -->` and `<!-- name: end -->`
    /// @throws Error if the document cannot be read or has no such lines
    Document(std::string path, const std::string& name) : path_(std::move(path)) {
        const std::string begin = "<!-- " + name + ": begin -->\n", end = "<!-- " + name + ": end -->";
        std::ifstream in(path_);
        require(in.is_open(), "cannot read ", path_, "; give a document that is there");
        std::stringstream all;
        all << in.rdbuf();
        const std::string text = all.str();
        const auto first = text.find(begin), last = text.find(end);
        require(first != std::string::npos && last != std::string::npos && first < last, path_, " has no lines ",
                begin.substr(0, begin.size() - 1), " and ", end, "; put them where the tables should be");
        before_ = text.substr(0, first + begin.size());
        generated_ = text.substr(first + begin.size(), last - first - begin.size());
        after_ = text.substr(last);
    }
    /// What stands between the lines.
    const std::string& generated() const { return generated_; }
    /// Puts something else there. Throws Error if the document cannot be written; it is then as it was.
    void replace(const std::string& generated) {
        generated_ = generated;
        AtomicFile whole(path_);
        whole << before_ + generated_ + after_;
        whole.commit();
    }

private:
    std::string path_, before_, generated_, after_;
};

} // namespace imbibe::bench
