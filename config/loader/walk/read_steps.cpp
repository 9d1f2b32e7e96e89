#include "config/loader/walk/read_steps.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "config/loader/values/checked_map.h"
#include "config/loader/values/single_key.h"
#include "config/loader/values/yaml_file.h"
#include "config/loader/walk/read_single_step.h"
#include "config/loader/yaml/source_text.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using engine::Step;

namespace {

constexpr std::size_t kMaxSteps = 100'000;
constexpr std::size_t kMaxIncludeDepth = 16;  // files included by files
constexpr std::size_t kMaxIncluded = 1'000;   // each is read again each time
constexpr std::uintmax_t kMaxIncludedBytes = 20'000'000;
constexpr const char* kSuffix = ".steps.yaml";

void read_list(const CheckedNode& section, StepContext& context, std::vector<Step>& out);

/// Counts steps, including those that a `repeat` would add; reports the step that exceeds the limit.
bool count_steps(std::size_t more, const CheckedNode& at, StepContext& context) {
    context.read += std::min(more, 2 * kMaxSteps);
    if (context.read <= kMaxSteps) {
        return true;
    }
    at.diagnose("too-many-steps",
                "with 'repeat' and 'include' the walk has more than " + std::to_string(kMaxSteps) + " steps");
    return false;
}

void read_repeat(const CheckedNode& node, StepContext& context, std::vector<Step>& out) {
    int times = 1;
    std::vector<Step> round;
    CheckedMap map(node, "'repeat'");
    map.require("times");
    map.as_int("times", 1, static_cast<int>(kMaxSteps), times);
    if (const auto steps = map.require("steps")) {
        ++context.repeats;
        read_list(*steps, context, round);
        --context.repeats;
    }
    map.refuse_other_keys();
    const auto rounds = static_cast<std::size_t>(times);
    if (count_steps((rounds - 1) * round.size(), node, context)) {
        for (std::size_t i = 0; i < rounds; ++i) {
            out.insert(out.end(), round.begin(), round.end());
        }
    }
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

/// Whether the file may be opened from the one that is being read.
bool may_include(const CheckedNode& node, const fs::path& path, StepContext& context) {
    if (std::ranges::any_of(context.files, [&](const fs::path& open) { return same_file(open, path); })) {
        node.diagnose("include-cycle", shown_path(path) + " includes itself through this line");
        return false;
    }
    if (context.files.size() > kMaxIncludeDepth) {
        node.diagnose("include-depth", "files include each other more than " +
                                           std::to_string(kMaxIncludeDepth) +
                                           " levels deep; use fewer files");
        return false;
    }
    std::error_code ignored;
    const std::uintmax_t bytes = fs::file_size(path, ignored);
    context.included_bytes += ignored ? 0 : bytes;
    context.included.push_back(path);
    if (context.included.size() > kMaxIncluded || context.included_bytes > kMaxIncludedBytes) {
        node.diagnose("too-many-steps",
                      "with this one the walk includes more than " + std::to_string(kMaxIncluded) +
                          " files or " + std::to_string(kMaxIncludedBytes / 1'000'000) + " MB; use 'repeat'");
        return false;
    }
    return true;
}

void read_steps_file(const CheckedNode& root, StepContext& context, std::vector<Step>& out) {
    CheckedMap map(root, "a steps file");
    if (const auto steps = map.require("steps")) {
        read_list(*steps, context, out);
    }
    map.refuse_other_keys();
}

void read_include(const CheckedNode& node, StepContext& context, std::vector<Step>& out) {
    const std::optional<std::string> written = node.line();
    if (!written) {
        return;
    }
    const fs::path path = context.files.back().parent_path() / *written;
    if (!may_include(node, path, context)) {
        return;
    }
    const auto file = YamlFile::open(path, kSuffix, context.roots, node.mark(), node.diagnostics());
    if (!file) {
        return;
    }
    context.files.push_back(path);
    read_steps_file(file->root(), context, out);
    context.files.pop_back();
}

/// For steps that expand to others.
struct ListReader {
    std::string_view name;
    void (*read)(const CheckedNode&, StepContext&, std::vector<Step>&) = nullptr;
};
constexpr std::array kListReaders = {ListReader{"repeat", read_repeat}, ListReader{"include", read_include}};

void read_list(const CheckedNode& section, StepContext& context, std::vector<Step>& out) {
    const std::vector<CheckedNode> nodes = section.items("a step");
    std::vector<std::string> known;
    add_names(step_readers(), known);
    add_names(kListReaders, known);
    for (const CheckedNode& node : nodes) {
        if (const auto step = single_key(node, "a step", "- spawn: gate", known)) {
            if (context.first && step->key != known.front()) {
                node.diagnose("bad-value", "the first step must be 'spawn': write `- spawn: gate`");
                context.first = false;
            }
            if (!count_steps(1, node, context)) {
                return;
            }
            if (const StepReader* single = entry_of(step_readers(), step->key)) {
                out.push_back(single->read(step->value, context));
            } else {
                entry_of(kListReaders, step->key)->read(step->value, context, out);
            }
        }
        context.first = false;
    }
    if (nodes.empty() && (section.is_sequence() || section.is_null())) {
        section.diagnose("bad-value", context.first ? "'steps' needs at least a spawn"
                                                    : "'steps' needs at least one step");
    }
}

}  // namespace

void read_steps(const CheckedNode& section, const WalkNames& names, const CameraKeys& camera,
                const fs::path& walk_file, const ReadRoots& roots, engine::Walk& walk) {
    StepContext context{names, walk.avatar, camera, roots, {walk_file}};
    read_list(section, context, walk.steps);
    walk.included = std::move(context.included);
}

std::vector<Step> read_standalone_steps(const CheckedNode& root, const WalkNames& names,
                                        const fs::path& steps_file, const ReadRoots& roots) {
    const engine::AvatarProfile avatar;
    const CameraKeys camera;
    std::vector<Step> steps;
    StepContext context{names, avatar, camera, roots, {steps_file}};
    context.standalone = true;
    context.first = false;
    read_steps_file(root, context, steps);
    return steps;
}

}  // namespace campuswalk::config
