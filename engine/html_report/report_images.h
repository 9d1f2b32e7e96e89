#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "engine/report/walk_result.h"

namespace campuswalk::engine {

/// A picture as a report contains it.
struct ReportImage {
    std::string bytes;
    std::string media_type;
};

/// Whether a report shows this file: a still picture.
bool is_still_image(const Artifact& artifact);

/// As WebP: pictures that are compared keep every pixel, others lose what is hard to see and are at most 1280
/// pixels wide. None for bytes that can't be decoded.
std::optional<ReportImage> report_image(const Artifact& artifact, std::string_view bytes);

}  // namespace campuswalk::engine
