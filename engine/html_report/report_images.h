#pragma once

#include <string>

#include "engine/report/walk_result.h"
#include "scene/export/webp_image.h"

namespace campuswalk::engine {

/// A picture as a report contains it.
struct ReportImage {
    std::string bytes;
    std::string media_type;
};

/// Whether a report shows this file: a still picture.
bool is_still_image(const Artifact& artifact);

/// As WebP: pictures that are compared keep every pixel, others lose what is hard to see and are at most 1280
/// pixels wide.
ReportImage report_image(const Artifact& artifact, const scene::PixelView& pixels);

}  // namespace campuswalk::engine
