#pragma once

#include "config/loader/values/number.h"

namespace campuswalk::config {

// The ranges of lengths, angles and times in all files. The limits catch values in the wrong unit, and keep
// whatever is computed from them finite.

constexpr Range kCoordinate{-1e7, 1e7, false, "m"};
constexpr Range kPositiveLength{0.0, 1e6, true, "m"};
constexpr Range kDistance{0.0, 1e6, false, "m"};
constexpr Range kSlope{0.0, 89.0, false, "degrees"};
constexpr Range kYaw{-3600.0, 3600.0, false, "degrees"};
constexpr Range kSeconds{0.0, 86'400.0, false, "s"};
constexpr Range kTimeout{0.0, 86'400.0, true, "s"};
constexpr Range kSpeed{0.0, 100.0, true, "m/s"};
constexpr Range kFieldOfView{1.0, 170.0, false, "degrees"};

}  // namespace campuswalk::config
