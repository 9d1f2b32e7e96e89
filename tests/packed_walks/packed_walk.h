#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/script/walk.h"
#include "scene/campus/campus.h"

namespace campuswalk::packed {

/// A walk and the campus it is played on, as one file that needs neither importer nor YAML reader to be
/// played. Models, which are only drawn, are left out.
std::vector<std::byte> pack_walk(const scene::Campus& campus, const engine::Walk& walk);

struct PackedWalk {
    scene::Campus campus;
    engine::Walk walk;
};

/// Rebuilds every mesh's tree; the broad phase is linear. Throws scene::DamagedFile.
PackedWalk unpack_walk(std::span<const std::byte> bytes);

}  // namespace campuswalk::packed
