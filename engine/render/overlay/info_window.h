#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/overlay/canvas.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::engine::render {

/// The content of a building's information window; empty fields are omitted.
struct InfoWindow {
    std::string title;
    std::string kind;
    std::string hours;  ///< as in the campus file; see readable_hours
    std::string text;
    int floors = 0;                         ///< 0 = unknown
    std::optional<Eigen::Vector2d> anchor;  ///< position of the building in the image, pixels
};

/// The window of an open pop-up. The building's id replaces an empty title.
InfoWindow info_window_of(const scene::Building& building, const OpenPopup& popup);

/// "08-22" and "8:30-22" become "08:00 – 22:00" and "08:30 – 22:00"; anything else is returned unchanged.
std::string readable_hours(const std::string& hours);

/// Stacks the windows on the right side: the first expanded, others collapsed, and "+n more" for those that
/// don't fit or exceed `max_windows`. Returns the rectangles of those drawn.
std::vector<PixelRect> draw_info_windows(const Canvas& canvas, std::span<const InfoWindow> windows,
                                         std::size_t max_windows);

}  // namespace campuswalk::engine::render
