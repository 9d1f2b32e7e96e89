#pragma once

#include "config/loader/values/checked_map.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads the key `popup` of a building or a collider, if present: true, false, or a map with `once`,
/// `cooldown` and `dwell`.
void read_popup_rule(CheckedMap& map, bool& popup, scene::PopupRule& rule);

/// Reads `info` of a building: NAME: TEXT, each available to texts as a variable.
std::vector<scene::InfoField> read_info(const CheckedNode& node);

/// Reports undefined variables (unknown-name) and unclosed braces (bad-value) in a pop-up's text, which is
/// written at `node`. Call after the building's other keys have been read.
void check_popup_title(const CheckedNode& node, const scene::Building& building);
void check_popup_text(const CheckedNode& node, const scene::Building& building);

}  // namespace campuswalk::config
