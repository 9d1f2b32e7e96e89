#pragma once

#include "config/loader/values/checked_map.h"
#include "config/loader/values/checked_node.h"
#include "engine/script/expectation.h"

namespace campuswalk::config {

// Each reads the value of an expectation that is evaluated after the walk, by code that has the files.

engine::Expectation read_log(const CheckedNode& node);
engine::Expectation read_expected_snapshot(const CheckedNode& node);
/// Always an ExpectVisible.
engine::Expectation read_visible(const CheckedNode& node);

/// `threshold`, `max_diff_pixels`, `max_diff_pixel_ratio`, `min_tile_ssim` and `masks`, any of them.
void read_tolerance(CheckedMap& map, engine::ToleranceChanges& changes);

}  // namespace campuswalk::config
