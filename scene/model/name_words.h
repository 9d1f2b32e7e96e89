#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::scene {

/// What nodes' names tell of what they are, in the languages that modellers write them in.

/// A name's runs of letters, in lower case, split also where a capital follows a small letter: `FrontDoor_01`
/// is `front`, `door`. Characters beyond ASCII count as letters.
std::vector<std::string> words_of(std::string_view name);

/// Whether it names a door: English, German, French, Spanish, Italian, Dutch, Swedish, Polish, Russian,
/// Chinese, Japanese or Korean. A part of one (`door_frame`, `Türgriff`, `doorbell`) is none.
bool is_door_name(std::string_view name);

/// Likewise for flights of stairs.
bool is_stairs_name(std::string_view name);

/// Whether it names what is no building: plants, ways, ground, water, walls, furniture of streets and rooms.
bool is_surroundings_name(std::string_view name);

/// Whether an identifier was put where a name should be: a GUID, a long hexadecimal number, IFC's 22
/// characters of base 64, or digits alone.
bool is_identifier(std::string_view name);

}  // namespace campuswalk::scene
