#pragma once

#include "config/loader/values/checked_map.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

/// Reads the key `popup` of a building or a collider, if it is there: true, false, or a map with `once`,
/// `cooldown` and `dwell`.
void read_popup_rule(CheckedMap& map, bool& popup, scene::PopupRule& rule);

/// Reads `info` of a building: NAME: TEXT, each a variable of its own.
std::vector<scene::InfoField> read_info(const CheckedNode& node);

/// Complains (unknown-name) of variables in a pop-up's texts that nothing stands for, and of braces that
/// aren't closed. Call when the building's other keys have been read; `node` is where the text stands.
void check_popup_title(const CheckedNode& node, const scene::Building& building);
void check_popup_text(const CheckedNode& node, const scene::Building& building);

}  // namespace campuswalk::config
