#include "config/loader/read_steps.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "config/loader/checked_map.h"
#include "config/loader/read_single_step.h"
#include "config/loader/single_key.h"
#include "config/loader/source_text.h"
#include "config/loader/step_context.h"
#include "config/loader/yaml_file.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

using engine::Step;

namespace {

constexpr std::size_t kMostSteps = 100'000;
constexpr std::size_t kMostDeep = 16;  // files included by files
constexpr const char* kSuffix = ".steps.yaml";

void read_list(const CheckedNode& section, StepContext& context, std::vector<Step>& out);

/// Counts steps that are there or would be; complains when they are too many, at the step that makes them so.
bool count_steps(std::size_t more, const CheckedNode& at, StepContext& context) {
    context.read += std::min(more, 2 * kMostSteps);
    if (context.read <= kMostSteps) {
        return true;
    }
    at.diagnose("too-many-steps", "with 'repeat' and 'include' the walk has more than " +
                                      std::to_string(kMostSteps) + " steps");
    return false;
}

void read_repeat(const CheckedNode& node, StepContext& context, std::vector<Step>& out) {
    int times = 1;
    std::vector<Step> round;
    CheckedMap map(node, "'repeat'");
    map.require("times");
    map.whole_number("times", 1, static_cast<int>(kMostSteps), times);
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
    std::error_code none;
    return fs::equivalent(a, b, none);
}

/// Whether the file may be opened from the one that is being read.
bool may_include(const CheckedNode& node, const fs::path& path, const StepContext& context) {
    if (std::ranges::any_of(context.files, [&](const fs::path& open) { return same_file(open, path); })) {
        node.diagnose("include-cycle", shown_path(path) + " includes itself, by way of this line");
        return false;
    }
    if (context.files.size() > kMostDeep) {
        node.diagnose("include-depth", "files include each other more than " + std::to_string(kMostDeep) +
                                           " deep; put the steps into fewer files");
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
    const auto file = YamlFile::open(path, kSuffix, node.mark(), node.diagnostics());
    if (!file) {
        return;
    }
    context.files.push_back(path);
    read_steps_file(file->root(), context, out);
    context.files.pop_back();
}

template <Step (*read)(const CheckedNode&, StepContext&)>
void read_one(const CheckedNode& node, StepContext& context, std::vector<Step>& out) {
    out.push_back(read(node, context));
}

using StepReader = void (*)(const CheckedNode&, StepContext&, std::vector<Step>&);
constexpr std::array kSteps = {Choice<StepReader>{"spawn", read_one<read_spawn>},
                               Choice<StepReader>{"walk_to", read_one<read_walk_to>},
                               Choice<StepReader>{"follow", read_one<read_follow>},
                               Choice<StepReader>{"run", read_one<read_run>},
                               Choice<StepReader>{"speed", read_one<read_speed>},
                               Choice<StepReader>{"jump", read_one<read_jump>},
                               Choice<StepReader>{"crouch", read_one<read_crouch>},
                               Choice<StepReader>{"expect", read_one<read_expect>},
                               Choice<StepReader>{"wait", read_one<read_wait>},
                               Choice<StepReader>{"wait_until", read_one<read_wait_until>},
                               Choice<StepReader>{"turn", read_one<read_turn>},
                               Choice<StepReader>{"look_at", read_one<read_look_at>},
                               Choice<StepReader>{"teleport", read_one<read_teleport>},
                               Choice<StepReader>{"enable", read_one<read_enable>},
                               Choice<StepReader>{"disable", read_one<read_disable>},
                               Choice<StepReader>{"snapshot", read_one<read_snapshot>},
                               Choice<StepReader>{"repeat", read_repeat},
                               Choice<StepReader>{"include", read_include}};

void read_list(const CheckedNode& section, StepContext& context, std::vector<Step>& out) {
    const std::vector<CheckedNode> nodes = section.items("a step");
    for (const CheckedNode& node : nodes) {
        const bool known_as_first = context.first;
        if (const auto step = single_key(node, "a step", kSteps)) {
            if (known_as_first && step->meaning != kSteps.front().value) {
                node.diagnose("bad-value", "the first step must be 'spawn', as in 'spawn: main-gate'");
                context.first = false;
            }
            if (!count_steps(1, node, context)) {
                return;
            }
            step->meaning(step->value, context, out);
        }
        context.first = false;
    }
    if (nodes.empty() && (section.is_sequence() || section.is_null())) {
        section.diagnose("bad-value", context.first ? "'steps' needs at least a spawn"
                                                    : "'steps' needs at least one step");
    }
}

}  // namespace

std::vector<Step> read_steps(const CheckedNode& section, const CampusNames& names,
                             const engine::AvatarProfile& avatar, const CameraKeys& camera,
                             const fs::path& walk_file) {
    std::vector<Step> steps;
    StepContext context{names, avatar, camera, {walk_file}};
    read_list(section, context, steps);
    return steps;
}

std::vector<Step> read_steps_alone(const CheckedNode& root, const fs::path& steps_file) {
    const CampusNames unknown(nullptr);
    const engine::AvatarProfile avatar;
    const CameraKeys camera;
    std::vector<Step> steps;
    StepContext context{unknown, avatar, camera, {steps_file}};
    context.first = false;
    read_steps_file(root, context, steps);
    return steps;
}

}  // namespace campuswalk::config
