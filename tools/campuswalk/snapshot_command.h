#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/script/walk.h"
#include "tools/campuswalk/rendering_backend.h"

namespace campuswalk::tools {

struct SnapshotOptions {
    std::filesystem::path campus;
    /// "top" for a plan of everything, a spawn's name to look from there, or a camera's keys as in a walk:
    /// "{view: orbit, around: library}".
    std::string camera = "top";
    std::string light;  ///< as in a walk: a profile's name or what differs; empty: day
    engine::ImageChannels channels;
    engine::ImageOverlays overlays;
    std::vector<std::string> overlay_names;  ///< go into `overlays` too
    std::filesystem::path output;
    int width = 1280;  ///< pixels
    int height = 720;  ///< pixels
    Backend backend = Backend::automatic;
};

/// Draws one image of a campus nobody walks in. Returns the exit code.
int draw_snapshot(const SnapshotOptions& options);

}  // namespace campuswalk::tools
