// A disk that is full, for a test: the system refuses to let files of this process grow beyond a size.
#pragma once

#include <csignal>
#include <sys/resource.h>

namespace output_test {

/// While it lives, no file can grow beyond `bytes` bytes.
class FullDisk {
public:
    explicit FullDisk(unsigned long bytes) {
        old_signal_ = std::signal(SIGXFSZ, SIG_IGN); // the write shall fail, not the process
        getrlimit(RLIMIT_FSIZE, &old_limit_);
        rlimit limit = old_limit_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &old_limit_);
        std::signal(SIGXFSZ, old_signal_);
    }

private:
    rlimit old_limit_{};
    void (*old_signal_)(int) = SIG_DFL;
};

} // namespace output_test
