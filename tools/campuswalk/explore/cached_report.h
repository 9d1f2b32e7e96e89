#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "engine/script/avatar.h"
#include "engine/walkspace/report/walk_report.h"
#include "scene/cache/cache_folder.h"
#include "scene/cache/content_hash.h"

namespace campuswalk::tools::explore {

/// What a report depends on.
struct ReportInputs {
    std::optional<scene::ContentHash> campus;  ///< of all that it was read from; none: isn't known
    std::size_t objects = 0;                   ///< of the campus
    const engine::AvatarProfile& avatar;
    const engine::ExploreSettings& settings;
    double min_width = 0.0;
};

/// The report that `make` made earlier from the same files, for the same body among the same enabled objects,
/// by the same program; else what `make` returns. Without a cache (null), always the latter.
engine::WalkReport cached_report(const ReportInputs& inputs, const scene::CacheFolder* cache,
                                 const std::function<engine::WalkReport()>& make);

}  // namespace campuswalk::tools::explore
