#include "tools/campuswalk_bench/engines/peer_engines.h"

#include <dlfcn.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

void* find_in_peer(const std::string& peer, const char* function) {
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path() / "peers";
    const fs::path file = folder / (peer + ".so");
    if (!fs::exists(file, ignored)) {
        throw std::runtime_error("not built");
    }
    // Never closed: the libraries behind it keep threads and exit handlers.
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw std::runtime_error(dlerror());
    }
    void* found = dlsym(library, function);
    if (found == nullptr) {
        throw std::runtime_error("it has no " + std::string(function));
    }
    return found;
}

void unless_absent(const char* peer, const std::function<void()>& use) {
    try {
        use();
    } catch (const std::exception& error) {
        std::printf("  absent: %s: %s\n", peer, error.what());
    }
}

}  // namespace campuswalk::tools::bench
