#pragma once

#include <filesystem>
#include <functional>

#include "engine/script/avatar.h"
#include "engine/walkspace/walk_report.h"
#include "scene/cache/cache_folder.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools::explore {

/// What a report depends on.
struct ReportInputs {
    const std::filesystem::path& campus_file;
    const scene::Campus& campus;
    const engine::AvatarProfile& avatar;
    const engine::ExploreSettings& settings;
    double min_width = 0.0;
};

/// The report that `make` made earlier from the same files, for the same body among the same enabled objects,
/// by the same program; else what `make` returns. Without a cache (null), always the latter.
engine::WalkReport cached_report(const ReportInputs& inputs, const scene::CacheFolder* cache,
                                 const std::function<engine::WalkReport()>& make);

}  // namespace campuswalk::tools::explore
