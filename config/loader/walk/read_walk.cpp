#include "config/loader/walk/read_walk.h"

#include <array>

#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/walk/read_camera.h"
#include "config/loader/walk/read_expectations.h"
#include "config/loader/walk/read_steps.h"

namespace campuswalk::config {

using engine::WalkStatus;

namespace {

engine::SimSettings read_sim(const CheckedNode& node) {
    constexpr int kMaxTicksPerSecond = 10'000;
    constexpr std::array kTrees = {Choice<collision::TreeKind>{"bvh8", collision::TreeKind::bvh8},
                                   Choice<collision::TreeKind>{"hybrid", collision::TreeKind::hybrid}};
    engine::SimSettings sim;
    CheckedMap map(node, "'sim'");
    map.as_int("ticks_per_second", 1, kMaxTicksPerSecond, sim.ticks_per_second);
    map.number("stay_every", kSeconds, sim.stay_every);
    map.number("gaze_hold", kSeconds, sim.gaze_hold);
    map.choice("tree", kTrees, sim.tree);
    map.refuse_other_keys();
    return sim;
}

CameraKeys read_camera(const CheckedNode& node, const CampusNames& names) {
    CameraKeys camera;
    CheckedMap map(node, "'camera'");
    read_camera_fields(map, names, camera);
    map.refuse_other_keys();
    return camera;
}

using Kind = WalkStatus::Kind;
constexpr std::array kKinds = {Choice<Kind>{"run", Kind::run}, Choice<Kind>{"skip", Kind::skip},
                               Choice<Kind>{"only", Kind::only}, Choice<Kind>{"xfail", Kind::xfail}};

std::vector<std::string> read_codes(const CheckedNode& node) {
    const std::vector<std::string> known = engine::failure_codes();
    std::vector<std::string> codes;
    const std::vector<CheckedNode> items = node.items_or_one("a failure");
    for (const CheckedNode& item : items) {
        const std::optional<std::string> code = item.is_scalar() ? item.text() : std::nullopt;
        if (code && engine::is_lack(*code)) {
            item.diagnose("bad-value",
                          "'" + *code +
                              "' says that something is lacking which the walk's verdict needs; no walk may "
                              "be expected to fail for that");
        } else if (const auto index = item.one_of(known)) {
            codes.push_back(known[*index]);
        }
    }
    if (items.empty() && (node.is_sequence() || node.is_null())) {
        node.diagnose("bad-value",
                      "'failures' must list at least one code; leave it out to accept any failure");
    }
    return codes;
}

/// run, skip, only or xfail, or a map with `is`, `because` and, for an xfail, `failures`.
WalkStatus read_status(const CheckedNode& node) {
    WalkStatus status;
    status.mark = node.mark();
    if (!node.is_map()) {
        status.kind = node.choice(kKinds).value_or(Kind::run);
        return status;
    }
    CheckedMap map(node, "'status'");
    map.require("is");
    map.choice("is", kKinds, status.kind);
    if (const auto because = map.find("because")) {
        status.reason = because->line().value_or("");
    }
    if (const auto failures = map.find("failures")) {
        status.codes = read_codes(*failures);
        if (status.kind != Kind::xfail) {
            map.diagnose_at("failures", "bad-value", "'failures' requires 'is: xfail'");
        }
    }
    map.refuse_other_keys();
    return status;
}

/// A kebab-case word or a list of them, each once.
std::vector<std::string> read_tags(const CheckedNode& node) {
    std::vector<std::string> tags;
    UniqueNames names("tag");
    for (const CheckedNode& item : node.items_or_one("a tag")) {
        if (const auto tag = kebab_name(item)) {
            tags.push_back(*tag);
            names.add(*tag, item);
        }
    }
    return tags;
}

}  // namespace

void read_walk(CheckedMap& map, const WalkNames& names, const std::filesystem::path& walk_file,
               const ReadRoots& roots, engine::Walk& walk) {
    if (const auto sim = map.find("sim")) {
        walk.sim = read_sim(*sim);
    }
    if (const auto status = map.find("status")) {
        walk.status = read_status(*status);
    }
    if (const auto tags = map.find("tags")) {
        walk.tags = read_tags(*tags);
    }
    map.number("timeout", kTimeout, walk.timeout);
    CameraKeys camera;
    if (const auto node = map.find("camera")) {
        camera = read_camera(*node, names.campus);
    }
    walk.camera = camera.settings();
    walk.views = camera.views();
    if (const auto steps = map.require("steps")) {
        read_steps(*steps, names, camera, walk_file, roots, walk);
    }
    if (const auto expect = map.find("expect")) {
        walk.expectations = read_expectations(*expect, names);
    }
}

}  // namespace campuswalk::config
