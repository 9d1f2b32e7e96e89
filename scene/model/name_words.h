#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::scene {

/// Classifies nodes by the words in their names, in the languages that modellers use.

/// The words of a name in lower case, split at non-letters and before a capital that follows a lower-case
/// letter: `FrontDoor_01` yields `front`, `door`. Non-ASCII characters count as letters.
std::vector<std::string> words_of(std::string_view name);

/// Whether the name means a door in English, German, French, Spanish, Italian, Dutch, Swedish, Polish,
/// Russian, Chinese, Japanese or Korean. False for parts of doors: `door_frame`, `Türgriff`, `doorbell`.
bool is_door_name(std::string_view name);

/// Whether it means stairs, in the same languages.
bool is_stairs_name(std::string_view name);

/// Whether it means something other than a building: plants, paths, terrain, water, fences, vehicles, flags,
/// markings, furniture. False if it also means a building: `Lake House`, `bus station`.
bool is_surroundings_name(std::string_view name);

/// Whether it means water, in the languages of is_door_name. False if it also means a building: `Lake House`.
bool is_water_name(std::string_view name);

/// Whether it means the sky or clouds: `skybox`, `sky_dome`. False if it also means a building.
bool is_sky_name(std::string_view name);

/// Whether it means what was cut out of something else, a boolean operand: `CUTTER.001`, `CTRL_Hole`.
bool is_operand_name(std::string_view name);

/// Whether it means a part of a building: walls, floors, storeys, rooms, roofs, windows, doors, columns.
bool is_building_part_name(std::string_view name);

/// Whether an importer generated the name because the file has none. Such names change with the file.
bool is_generated_name(std::string_view name);

/// Whether it says only how something was modelled: `Cube.012`, `Mesh_4`, `Group 7`.
bool is_default_name(std::string_view name);

/// Whether it is an identifier instead of a name: a GUID, a long hexadecimal number, IFC's 22 characters of
/// base64, or digits only.
bool is_identifier(std::string_view name);

}  // namespace campuswalk::scene
