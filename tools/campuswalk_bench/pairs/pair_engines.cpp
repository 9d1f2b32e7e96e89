#include "tools/campuswalk_bench/pairs/pair_engines.h"

#include <exception>

#include "tools/campuswalk_bench/engines/our_engines.h"
#include "tools/campuswalk_bench/engines/peer_engines.h"

namespace campuswalk::tools::bench {

using collision::TriangleMesh;

PairEngines make_engines(const TriangleMesh& a, const TriangleMesh& b, std::span<const char* const> names) {
    PairEngines made;
    for (const std::string name : names) {
        const bool is_ours = is_our_engine(name);
        try {
            made.engines.push_back(
                {name, is_ours,
                 is_ours ? make_our_engine(name, a, b) : make_peer<MakeEngine>(name, kMakeEngine, a, b)});
        } catch (const std::exception& error) {
            made.absent.push_back(name + ": " + error.what());
        }
    }
    return made;
}

}  // namespace campuswalk::tools::bench
