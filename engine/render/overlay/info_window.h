#pragma once

#include <optional>
#include <span>
#include <string>

#include <Eigen/Core>

#include "engine/record/tick_record.h"
#include "engine/render/overlay/canvas.h"
#include "scene/campus/campus_description.h"

namespace campuswalk::engine::render {

/// What an information window says about a building; empty fields take no room.
struct InfoWindow {
    std::string title;
    std::string kind;
    std::string hours;  ///< as the campus file has it; "08-22" is shown as "08:00 – 22:00"
    std::string text;
    int floors = 0;  ///< 0 = not said
    std::optional<Eigen::Vector2d>
        anchor;  ///< where the building is in the image, pixels: a line leads there
};

/// As it has opened: `title` and `text` with their variables filled in. The id stands in for no title.
InfoWindow info_window_of(const scene::Building& building, const OpenPopup& popup);

/// "08-22" and "8:30-22" become "08:00 – 22:00" and "08:30 – 22:00"; anything else stays as it is.
std::string readable_hours(const std::string& hours);

/// The rectangle that a window took, pixels.
struct WindowRect {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
};

/// Draws the windows down the right side without overlapping: the first in full, the next ones short, and
/// "+n more" for those that don't fit or exceed `max_windows`. Returns the frames of those drawn.
std::vector<WindowRect> draw_info_windows(const Canvas& canvas, std::span<const InfoWindow> windows,
                                          std::size_t max_windows);

}  // namespace campuswalk::engine::render
