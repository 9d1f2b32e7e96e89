#pragma once

#include <memory>
#include <string>
#include <type_traits>

#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// A function of a peer's library, which lies in the folder `peers` beside this program; the program links
/// none of them. Throws std::runtime_error, which says why there is none.
void* find_in_peer(const std::string& peer, const char* function);

/// make_peer<MakeEngine>("ode", kMakeEngine, a, b), and so on for the other kinds of engine.h. Throws like
/// the above and whatever the peer does.
template <typename Make, typename... Meshes>
auto make_peer(const std::string& peer, const char* function, const Meshes&... meshes) {
    auto* make = reinterpret_cast<Make*>(find_in_peer(peer, function));
    return std::unique_ptr<std::remove_pointer_t<decltype(make(meshes...))>>(make(meshes...));
}

}  // namespace campuswalk::tools::bench
