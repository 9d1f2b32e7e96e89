#pragma once

#include <functional>
#include <memory>
#include <string>
#include <type_traits>

#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

/// A function of a peer's library, which is in the folder `peers` beside this program; the program links none
/// of them. Throws std::runtime_error with the reason if there is none.
void* find_in_peer(const std::string& peer, const char* function);

/// Makes an engine of a peer: make_peer<MakeEngine>("ode", kMakeEngine, a, b), and likewise for the other
/// kinds in engine.h. Throws like find_in_peer, and what the peer throws.
template <typename Make, typename... Meshes>
auto make_peer(const std::string& peer, const char* function, const Meshes&... meshes) {
    auto* make = reinterpret_cast<Make*>(find_in_peer(peer, function));
    return std::unique_ptr<std::remove_pointer_t<decltype(make(meshes...))>>(make(meshes...));
}

/// Calls `use`; what it throws is printed as the reason why the peer is absent.
void unless_absent(const char* peer, const std::function<void()>& use);

}  // namespace campuswalk::tools::bench
