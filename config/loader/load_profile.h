#pragma once

#include <filesystem>
#include <string>

#include "config/loader/search_paths.h"
#include "engine/script/avatar.h"
#include "engine/script/camera.h"
#include "engine/script/light.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::config {

// Profiles by themselves, and what walks say of an avatar, a light or a camera by itself. Diagnostics about
// such a text name `source` as the file; profiles that it names are looked for near `folder`.

/// Reads `NAME.avatar.yaml` alone.
engine::AvatarProfile load_avatar(const std::filesystem::path& avatar_file, const SearchPaths& search = {});

/// Reads `NAME.light.yaml` alone.
engine::LightSettings load_light(const std::filesystem::path& light_file, const SearchPaths& search = {});

/// Reads an avatar as written in a walk: a profile's name or `{profile: adult, speed: 1.8}`.
engine::AvatarProfile read_avatar_text(const std::string& text, const std::string& source,
                                       const std::filesystem::path& folder,
                                       const scene::CampusDescription& campus, const SearchPaths& search);

/// Reads a light as written in a walk: a profile's name or `{profile: night, shadows: false}`.
engine::LightSettings read_light_text(const std::string& text, const std::string& source,
                                      const std::filesystem::path& folder, const SearchPaths& search);

/// Reads a camera's keys as written in a walk, such as `{view: orbit, around: library}`. View, size and field
/// of view default to those of `camera`.
engine::CameraSettings read_camera_text(const std::string& text, const std::string& source,
                                        const scene::CampusDescription& campus,
                                        const engine::CameraSettings& camera);

}  // namespace campuswalk::config
