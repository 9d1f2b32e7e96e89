#include "tools/campuswalk/bench/peer_engines.h"

#include <dlfcn.h>

#include <exception>
#include <filesystem>
#include <stdexcept>

namespace campuswalk::tools::bench {

namespace fs = std::filesystem;

using collision::TriangleMesh;

namespace {

constexpr const char* kPeers[] = {"fcl_obb", "bullet_gimpact", "ode", "embree", "cgal"};

std::unique_ptr<Engine> load_peer(const fs::path& file, const TriangleMesh& a, const TriangleMesh& b) {
    // Never closed: the libraries behind it keep threads and exit handlers.
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        throw std::runtime_error(dlerror());
    }
    auto* make = reinterpret_cast<MakePeer*>(dlsym(library, kMakePeer));
    if (make == nullptr) {
        throw std::runtime_error("it has no " + std::string(kMakePeer));
    }
    return std::unique_ptr<Engine>(make(a, b));
}

}  // namespace

Peers load_peers(const TriangleMesh& a, const TriangleMesh& b) {
    std::error_code none;
    const fs::path folder = fs::read_symlink("/proc/self/exe", none).parent_path() / "peers";
    Peers peers;
    for (const std::string name : kPeers) {
        const fs::path file = folder / (name + ".so");
        if (!fs::exists(file, none)) {
            peers.absent.push_back(name + ": not built");
            continue;
        }
        try {
            peers.engines.push_back({name, false, load_peer(file, a, b)});
        } catch (const std::exception& error) {
            peers.absent.push_back(name + ": " + error.what());
        }
    }
    return peers;
}

}  // namespace campuswalk::tools::bench
