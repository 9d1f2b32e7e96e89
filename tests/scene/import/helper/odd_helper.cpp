// An import helper that does what its argument says; see import_process_test.cpp.

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "scene/import/helper/limit_process.h"
#include "scene/import/helper/serve_import.h"

using namespace campuswalk::scene;

int main(int argc, char** argv) {
    const std::string_view way = argc > 1 ? argv[1] : "";
    if (way == "serve") {
        return serve_import();
    }
    if (way == "crash") {
        std::raise(SIGSEGV);
    }
    if (way == "abort") {
        std::abort();
    }
    if (way == "sleep") {
        sleep(1000);
    }
    if (way == "spin") {
        ImportLimits limits;
        limits.cpu = 1;
        limit_process(limits);
        for (std::atomic<unsigned int> i = 0;; ++i) {
        }
    }
    if (way == "garbage") {
        constexpr std::string_view kWords =
            "this is no model, whatever its writer says of it, and it is long enough";
        return write(STDOUT_FILENO, kWords.data(), kWords.size()) > 0 ? 0 : 1;
    }
    return way == "nothing" ? 0 : 3;
}
