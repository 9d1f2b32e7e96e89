#pragma once

#include <string_view>

#include "config/loader/checked_map.h"
#include "config/loader/number.h"
#include "engine/script/expectation.h"

namespace campuswalk::config {

/// The keys `equals`, `at_least` and `at_most` of a map that `what` names, as in "'count'". Complains when
/// none of them is there, and when nothing could meet them.
void read_limits(CheckedMap& map, std::string_view what, engine::Limits<int>& limits);

/// A number alone is `equals`; otherwise a map with those keys and no others.
engine::Limits<int> read_limits(const CheckedNode& node);
engine::Limits<double> read_limits(const CheckedNode& node, const Range& range);

}  // namespace campuswalk::config
