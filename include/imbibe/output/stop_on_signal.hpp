// Ctrl-C asks a run to end instead of ending the program.
#pragma once

#include <csignal>

namespace imbibe {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM do not end the program; asked() returns whether one has come. Its
/// destructor restores the former handlers. Of several objects the last one made counts.
class StopOnSignal {
public:
    /// From now on signals are noted.
    StopOnSignal() : interrupt_(std::signal(SIGINT, ask)), terminate_(std::signal(SIGTERM, ask)) { asked_ = 0; }
    ~StopOnSignal() {
        std::signal(SIGINT, interrupt_);
        std::signal(SIGTERM, terminate_);
    }
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    /// Has the user asked the program to end since this was made?
    static bool asked() { return asked_ != 0; }

private:
    static void ask(int) { asked_ = 1; }
    inline static volatile std::sig_atomic_t asked_ = 0;
    void (*interrupt_)(int);
    void (*terminate_)(int);
};

} // namespace imbibe
