// The basis of file readers: a file as bytes, words and numbers in a text, numbers in either byte order.
#pragma once

#include <imbibe/core/error.hpp>
#include <imbibe/core/number_in_text.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace imbibe {

/// Lengths in metres, for files without a unit: `read_mesh("gear.stl", millimetres)`.
inline constexpr double metres = 1, centimetres = 1e-2, millimetres = 1e-3, micrometres = 1e-6, inches = 0.0254;

namespace detail {

/// All bytes of a file. Throws Error if it cannot be read. @param who of the message
inline std::string bytes_of_file(const char* who, const std::filesystem::path& path) {
    std::error_code trouble;
    require(!std::filesystem::is_directory(path, trouble), who, ": ", path.string(), " is a folder, not a file.");
    std::ifstream in(path, std::ios::binary);
    require(in.is_open(), who, ": ", path.string(), " cannot be opened. Is the path right, seen from ",
            std::filesystem::current_path(trouble).string(), "?");
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    require(!in.bad(), who, ": ", path.string(), " cannot be read to its end.");
    return bytes;
}

/// Throws Error unless a length used as a unit is finite and above zero.
inline void require_unit(const char* who, double unit) {
    require(std::isfinite(unit) && unit > 0, who, ": unit = ", unit,
            " m must be finite and > 0 m. Give what one of the file's units is: metres, millimetres, inches.");
}

/// The number of type T at place `at` of `bytes`, in little-endian or big-endian order.
template <class T>
T number_at(std::string_view bytes, std::size_t at, bool little = true) {
    std::array<char, sizeof(T)> raw;
    std::memcpy(raw.data(), bytes.data() + at, sizeof(T));
    if (little != (std::endian::native == std::endian::little))
        for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
            std::swap(raw[i], raw[sizeof(T) - 1 - i]);
    return std::bit_cast<T>(raw);
}

/// A text word by word, with the number of the line.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    /// The next word, on this line or a later one; empty at the end.
    std::string_view next() {
        skip(true);
        return word();
    }
    /// The next word on this line; empty at its end.
    std::string_view next_on_line() {
        skip(false);
        return word();
    }
    /// Goes to the beginning of the next line.
    void skip_line() {
        while (at_ < text_.size() && text_[at_] != '\n')
            ++at_;
        if (at_ < text_.size())
            ++at_, ++line_;
    }
    [[nodiscard]] bool at_end() const { return at_ >= text_.size(); } ///< is nothing left?
    [[nodiscard]] long long line() const { return line_; }            ///< from 1
    [[nodiscard]] std::size_t place() const { return at_; }           ///< bytes read so far

private:
    static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
    void skip(bool lines) {
        for (; at_ < text_.size() && (is_space(text_[at_]) || (lines && text_[at_] == '\n')); ++at_)
            line_ += text_[at_] == '\n';
    }
    std::string_view word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_space(text_[at_]) && text_[at_] != '\n')
            ++at_;
        return text_.substr(begin, at_ - begin);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    long long line_ = 1;
};

/// The number that a word is, if it is one.
inline std::optional<double> number_of(std::string_view word) {
    if (!word.empty() && word.front() == '+')
        word.remove_prefix(1);
#if defined(__cpp_lib_to_chars)
    double value = 0;
    const auto [end, trouble] = std::from_chars(word.data(), word.data() + word.size(), value);
    return trouble == std::errc{} && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
#else
    const auto number = number_in_text(std::string(word));
    return number && number->is_all ? std::optional(number->value) : std::nullopt;
#endif
}

/// The whole number that a word is, if it is one.
inline std::optional<long long> whole_number_of(std::string_view word) {
    long long value = 0;
    const auto [end, trouble] = std::from_chars(word.data(), word.data() + word.size(), value);
    return trouble == std::errc{} && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

/// Part of a word of the file, printable in a message.
inline std::string quoted(std::string_view word) {
    std::string result = "\"";
    for (const char c : word.substr(0, 40))
        result += c >= ' ' && c < 127 ? c : '?';
    return result + (word.size() > 40 ? "...\"" : "\"");
}

} // namespace detail
} // namespace imbibe
