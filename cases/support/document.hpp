// A document with a part that a program writes, between two lines that stay.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/output/file.hpp>

#include <fstream>
#include <sstream>
#include <string>

namespace imbibe::bench {

/// Read when it is made, so that one that is not what it should be is noticed before anything is computed, and again
/// whenever it is asked for: while a run takes its hour, others write to the same document.
class Document {
public:
    /// @param name the lines are `<!-- name: begin -->` and `<!-- name: end -->`
    /// @throws Error if the document cannot be read or has no such lines, and so do the functions
    Document(std::string path, const std::string& name)
        : path_(std::move(path)), begin_("<!-- " + name + ": begin -->\n"), end_("<!-- " + name + ": end -->") {
        read();
    }
    /// What stands between the lines.
    std::string generated() const { return read().generated; }
    /// Puts something else there. Throws Error if the document cannot be written; it is then as it was.
    void replace(const std::string& generated) const {
        const Parts now = read();
        AtomicFile whole(path_);
        whole << now.before + generated + now.after;
        whole.commit();
    }

private:
    struct Parts {
        std::string before, generated, after;
    };
    Parts read() const {
        std::ifstream in(path_);
        require(in.is_open(), "cannot read ", path_, "; give a document that is there");
        std::stringstream all;
        all << in.rdbuf();
        const std::string text = all.str();
        const auto first = text.find(begin_), last = text.find(end_);
        require(first != std::string::npos && last != std::string::npos && first < last, path_, " has no lines ",
                begin_.substr(0, begin_.size() - 1), " and ", end_, "; put them where the tables should be");
        const auto from = first + begin_.size();
        return {text.substr(0, from), text.substr(from, last - from), text.substr(last)};
    }
    std::string path_, begin_, end_;
};

} // namespace imbibe::bench
