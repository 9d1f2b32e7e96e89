#include "tools/campuswalk/run/workers/interrupt.h"

#include <atomic>
#include <csignal>

namespace campuswalk::tools {

namespace {

std::atomic<int> requests{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler adds to it");

}  // namespace

void watch_for_interrupts() {
    for (const int signal : {SIGINT, SIGTERM}) {
        std::signal(signal, [](int) { ++requests; });
    }
}

bool interrupted() {
    return requests > 0;
}

bool interrupted_again() {
    return requests > 1;
}

}  // namespace campuswalk::tools
