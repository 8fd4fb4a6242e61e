// How an example draws its pictures: it calls one of the Python programs in tools/, and where that cannot be done it
// says in one line what to install.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace imbibe::example {

namespace detail {

/// `word` such that the shell takes it as it is, whatever characters it has.
inline std::string quoted(const std::string& word) {
    std::string safe = "'";
    for (const char c : word)
        safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

/// Whether the command ends well; what it prints is dropped.
inline bool succeeds(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

/// The Python that has matplotlib: the one named by the environment variable IMBIBE_PYTHON, the first in the search
/// path, or the system's (another one may hide it). Empty if none has.
inline std::string python() {
    const char* chosen = std::getenv("IMBIBE_PYTHON");
    for (const std::string candidate : {chosen ? chosen : "", "python3", "/usr/bin/python3"})
        if (!candidate.empty() && succeeds(quoted(candidate) + " -c 'import matplotlib, numpy'"))
            return candidate;
    return {};
}

/// The folder of the Python programs: the environment variable IMBIBE_TOOLS, or what CMake defined.
inline std::filesystem::path tools_folder() {
    if (const char* chosen = std::getenv("IMBIBE_TOOLS"))
        return chosen;
#ifdef IMBIBE_TOOLS_DIR
    return IMBIBE_TOOLS_DIR;
#else
    return "tools";
#endif
}

} // namespace detail

/// Runs `tools/<tool>` with `arguments`, for example `draw("plot_curves.py", {"out/sponge.csv", "-o",
/// "out/sponge.png"})`. Returns whether the picture was drawn. A picture is never worth a run: if it cannot be drawn,
/// one line on `log` says why and how to draw it later, and nothing is thrown.
inline bool draw(const std::string& tool, const std::vector<std::string>& arguments, std::ostream& log = std::cout) {
    const auto program = detail::tools_folder() / tool;
    std::string command = detail::quoted(program.string());
    for (const auto& argument : arguments)
        command += ' ' + detail::quoted(argument);

    if (!std::filesystem::exists(program)) {
        log << "No picture: " << program.string() << " is not there; set IMBIBE_TOOLS to the folder with " << tool
            << '\n';
        return false;
    }
    const auto python = detail::python();
    if (python.empty()) {
        log << "No picture: install python3-matplotlib, then run: python3 " << command << '\n';
        return false;
    }
    log << std::flush;
    if (std::system((detail::quoted(python) + ' ' + command).c_str()) != 0) {
        log << "No picture: this command failed: " << python << ' ' << command << '\n';
        return false;
    }
    return true;
}

} // namespace imbibe::example
