#include "tools/campuswalk/base/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace campuswalk::tools {

namespace {

/// Of a pipe or socket whose other end is closed. The errno of the write that failed is long gone.
bool has_no_reader(int stream) {
    pollfd state{.fd = stream, .events = POLLOUT, .revents = 0};
    return poll(&state, 1, 0) == 1 && (state.revents & POLLERR) != 0;
}

}  // namespace

void guard_standard_streams() {
    for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
        if (fcntl(stream, F_GETFD) == -1) {
            // Takes the lowest number that is free, which is `stream`. Read-only: writing to it still fails.
            static_cast<void>(open("/dev/null", O_RDONLY));
        }
    }
    std::signal(SIGPIPE, SIG_IGN);
}

void check_standard_output() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        constexpr const char* kWhat = "standard output can't be written";
        if (has_no_reader(STDOUT_FILENO)) {
            throw NoReader(kWhat);
        }
        throw std::runtime_error(kWhat);
    }
}

}  // namespace campuswalk::tools
