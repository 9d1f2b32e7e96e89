#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "engine/observers/observer.h"
#include "engine/script/walk.h"
#include "scene/campus.h"

namespace campuswalk::tools {

// What the program asks of rendering. A build without it (CAMPUSWALK_RENDER=OFF) answers no to the first
// and never calls the others.

bool can_draw();

/// Writes the walk's snapshots to `FOLDER/WALK NAME/`. `campus` must outlive it.
std::unique_ptr<engine::Observer> make_snapshot_taker(const scene::Campus& campus,
                                                      const std::filesystem::path& folder);

/// One picture of a campus: from above all of it, otherwise from `avatar`'s place.
void draw_campus(const scene::Campus& campus, const engine::CameraSettings& camera,
                 const engine::AvatarState& avatar, const std::filesystem::path& file);
void draw_plan(const scene::Campus& campus, int width, int height, const std::filesystem::path& file);

}  // namespace campuswalk::tools
