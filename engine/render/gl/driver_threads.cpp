#include "engine/render/gl/driver_threads.h"

#include <cstdlib>
#include <string>
#include <thread>

namespace campuswalk::engine::render {

void share_processors(std::size_t processes) {
    if (processes < 2) {
        return;  // the default: all processors
    }
    // The calling thread waits for the driver's threads, so a single one would gain nothing.
    const std::size_t threads = std::thread::hardware_concurrency() / processes;
    setenv("LP_NUM_THREADS", std::to_string(threads < 2 ? 0 : threads).c_str(), 0);
}

}  // namespace campuswalk::engine::render
