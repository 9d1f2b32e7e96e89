#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// What a report's index says of a walk besides its result.
struct WalkPlacement {
    std::ptrdiff_t campus = -1;           ///< index; -1: none is known
    std::ptrdiff_t thumbnail = -1;        ///< chunk of a picture; -1: none
    std::vector<std::int64_t> plan = {};  ///< see plan_of
};

/// The walk's row of the index, without its end: a JSON object to which the chunk and line of its details,
/// and
/// `}`, are to be added. A few hundred bytes.
std::string open_walk_row(const WalkResult& result, const WalkPlacement& placement);

/// The first bytes of the text, at most `most`, without half a character.
std::string shortened(const std::string& text, std::size_t most);

}  // namespace campuswalk::engine
