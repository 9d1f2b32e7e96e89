#include "tools/campuswalk/explore/cached_report.h"

#include <cstdint>
#include <span>
#include <vector>

#include "engine/walkspace/report/report_file.h"
#include "scene/base/binary_archive.h"

namespace campuswalk::tools::explore {

using engine::WalkReport;
using scene::ContentHash;
using scene::ContentHasher;

namespace {

const scene::CacheFolder::Kind kReportKind = "reach";

void add(ContentHasher& hasher, const collision::Vec3& p) {
    hasher.add_number(p.x());
    hasher.add_number(p.y());
    hasher.add_number(p.z());
}

void add(ContentHasher& hasher, const engine::AvatarProfile& avatar) {
    for (const double number :
         {avatar.height, avatar.radius, avatar.eye_height, avatar.speed, engine::running_speed(avatar),
          avatar.step_height, avatar.max_slope, avatar.skin_width, avatar.look_distance}) {
        hasher.add_number(number);
    }
    hasher.add_number(std::uint64_t{avatar.ignore_layers.size()});
    for (const std::string& layer : avatar.ignore_layers) {
        hasher.add_text(layer);
    }
}

void add(ContentHasher& hasher, const engine::ExploreSettings& settings) {
    hasher.add_number(std::uint64_t{settings.max_nodes});
    for (const bool flag : {settings.run, settings.jump, settings.strides.full_height.has_value()}) {
        hasher.add_number(std::uint64_t{flag ? 1U : 0U});
    }
    for (const collision::Vec3& start : settings.starts) {
        add(hasher, start);
    }
    if (settings.solids.disabled != nullptr) {
        for (std::size_t i = 0; i < settings.solids.disabled->size(); ++i) {
            if ((*settings.solids.disabled)[i]) {
                hasher.add_number(std::uint64_t{i});
            }
        }
    }
}

ContentHash key_of(const ReportInputs& inputs) {
    ContentHasher hasher;
    hasher.add_text(kReportKind);
    hasher.add_hash(*inputs.campus);
    add(hasher, inputs.avatar);
    add(hasher, inputs.settings);
    hasher.add_number(inputs.min_width);
    return hasher.result();
}

std::optional<WalkReport> find(const ContentHash& key, const scene::CacheFolder& cache, std::size_t objects) {
    try {
        const auto file = cache.find(key, kReportKind);
        return file ? std::optional(engine::read_report_file(file->bytes(), objects)) : std::nullopt;
    } catch (const scene::DamagedFile&) {
        return std::nullopt;  // as if it weren't there
    }
}

}  // namespace

WalkReport cached_report(const ReportInputs& inputs, const scene::CacheFolder* cache,
                         const std::function<WalkReport()>& make) {
    if (cache == nullptr || !inputs.campus) {
        return make();
    }
    const ContentHash key = key_of(inputs);
    if (std::optional<WalkReport> known = find(key, *cache, inputs.objects)) {
        return std::move(*known);
    }
    WalkReport report = make();
    const std::vector<std::byte> bytes = engine::archive_report(report);
    const std::span<const std::byte> buffer(bytes);
    cache->store(key, kReportKind, std::span(&buffer, 1));
    return report;
}

}  // namespace campuswalk::tools::explore
