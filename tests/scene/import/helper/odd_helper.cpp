// An import helper that misbehaves as its argument says, for import_process_test.cpp.

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "scene/import/helper/serve_import.h"

using namespace campuswalk::scene;

int main(int argc, char** argv) {
    const std::string_view behaviour = argc > 1 ? argv[1] : "";
    if (behaviour == "serve") {
        return serve_import();
    }
    if (behaviour == "crash") {
        std::raise(SIGSEGV);
    }
    if (behaviour == "abort") {
        std::abort();
    }
    if (behaviour == "sleep") {
        sleep(1000);
    }
    if (behaviour == "spin") {
        ImportLimits limits;
        limits.cpu = 1;
        limit_process(limits);
        for (std::atomic<unsigned int> i = 0;; ++i) {
        }
    }
    if (behaviour == "garbage") {
        constexpr std::string_view kGarbage =
            "not a model, but longer than the header of one, so that its contents are looked at";
        return write(STDOUT_FILENO, kGarbage.data(), kGarbage.size()) > 0 ? 0 : 1;
    }
    return behaviour == "nothing" ? 0 : 3;
}
