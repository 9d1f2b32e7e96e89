#include "config/loader/walk/read_late_expectation.h"

#include <array>
#include <vector>

#include "config/loader/values/names.h"

namespace campuswalk::config {

using namespace engine;

namespace {

constexpr Range kShare{0.0, 1.0, false, ""};
constexpr Range kSimilarity{-1.0, 1.0, false, ""};
constexpr int kMaxPixels = 1'000'000'000;

std::optional<int> find_pixels(CheckedMap& map, std::string_view key) {
    const auto node = map.find(key);
    return node ? node->as_int(0, kMaxPixels) : std::nullopt;
}

/// `[x, y, width, height]`
std::optional<PixelBox> read_mask(const CheckedNode& node) {
    const std::vector<CheckedNode> items = node.items("a number of a mask");
    std::array<int, 4> numbers{};
    if (node.is_sequence() && items.size() != numbers.size()) {
        node.diagnose("bad-value", "a mask is [x, y, width, height] in pixels");
        return std::nullopt;
    }
    for (std::size_t i = 0; i < items.size(); ++i) {
        numbers[i] = items[i].as_int(0, kMaxPixels).value_or(0);
    }
    return PixelBox{numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace

Expectation read_log(const CheckedNode& node) {
    ExpectLog log;
    log.mark = node.mark();
    CheckedMap map(node, "'log'");
    map.require("golden");
    map.as_bool("golden", log.golden);
    map.refuse_other_keys();
    return log;
}

void read_tolerance(CheckedMap& map, ToleranceChanges& changes) {
    map.number("threshold", kShare, changes.threshold);
    changes.max_diff_pixels = find_pixels(map, "max_diff_pixels");
    map.number("max_diff_pixel_ratio", kShare, changes.max_diff_pixel_ratio);
    map.number("min_tile_ssim", kSimilarity, changes.min_tile_ssim);
    if (const auto masks = map.find("masks")) {
        for (const CheckedNode& mask : masks->items("a mask")) {
            changes.masks.push_back(read_mask(mask).value_or(PixelBox{}));
        }
    }
}

Expectation read_expected_snapshot(const CheckedNode& node) {
    ExpectSnapshot snapshot;
    snapshot.mark = node.mark();
    if (!node.is_map()) {
        snapshot.name = kebab_name(node).value_or("");
        return snapshot;
    }
    CheckedMap map(node, "'snapshot'");
    if (const auto name = map.require("name")) {
        snapshot.mark = name->mark();
        snapshot.name = kebab_name(*name).value_or("");
    }
    read_tolerance(map, snapshot.tolerance);
    map.refuse_other_keys();
    return snapshot;
}

Expectation read_visible(const CheckedNode& node) {
    ExpectVisible visible;
    visible.mark = visible.building.mark = visible.snapshot_mark = node.mark();
    CheckedMap map(node, "'visible'");
    if (const auto building = map.require("building")) {
        visible.building = {building->mark(), building->line().value_or("*")};
    }
    if (const auto snapshot = map.require("in")) {
        visible.snapshot_mark = snapshot->mark();
        visible.snapshot = kebab_name(*snapshot).value_or("");
    }
    visible.min_pixels = find_pixels(map, "min_pixels").value_or(visible.min_pixels);
    map.number("min_ratio", kShare, visible.min_ratio);
    map.refuse_other_keys();
    return visible;
}

}  // namespace campuswalk::config
