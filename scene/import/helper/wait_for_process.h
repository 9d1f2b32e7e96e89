#pragma once

#include <sys/types.h>

#include <cstdint>

namespace campuswalk::scene {

/// How a process ended.
struct Ending {
    int exit_code = 0;
    int signal = 0;            ///< that ended it, 0 for none
    bool out_of_time = false;  ///< ended by us
    std::uint32_t cpu_seconds = 0;
};

/// Waits for a child; after `most_seconds` kills it. It is gone afterwards in any case.
Ending wait_for_process(pid_t process, std::uint32_t most_seconds);

}  // namespace campuswalk::scene
