#include "tools/campuswalk/suggest/lint_text.h"

#include <algorithm>
#include <utility>

#include "engine/events/decimals.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/print.h"

namespace campuswalk::tools {

namespace {

/// Who or what it is, and why it isn't solid.
std::string text_of(scene::IntangibleNode::Kind kind, std::size_t count) {
    switch (kind) {
        case scene::IntangibleNode::Kind::sky:
            return scene::plural(count, "sky node") +
                   " around or above everything, left out of sizes and maps";
        case scene::IntangibleNode::Kind::water:
            return scene::plural(count, "water node") + ", which nobody walks on";
        case scene::IntangibleNode::Kind::operand:
            return scene::plural(count, "box node") +
                   " that openings were cut with: delete them in the model";
    }
    return "";
}

}  // namespace

std::vector<scene::ModelLint> intangible_lints(const UprightModel& upright) {
    using Kind = scene::IntangibleNode::Kind;
    std::vector<scene::ModelLint> lints;
    for (const Kind kind : {Kind::sky, Kind::water, Kind::operand}) {
        scene::ModelLint lint{"not-solid", "", {}};
        for (const scene::IntangibleNode& each : upright.intangible) {
            if (each.kind == kind) {
                const scene::Node& node = upright.model.nodes[each.node];
                lint.places.push_back({node.name, node.X_world_node.topRightCorner<3, 1>()});
            }
        }
        if (!lint.places.empty()) {
            lint.message = text_of(kind, lint.places.size()) + "; --suggest leaves them out of what is solid";
            lints.push_back(std::move(lint));
        }
    }
    return lints;
}

void print_lints(const std::vector<scene::ModelLint>& lints) {
    constexpr std::size_t kMax = 5;
    for (const scene::ModelLint& lint : lints) {
        print_line("  %s: %s", std::string(lint.code.text()).c_str(), lint.message.c_str());
        for (std::size_t p = 0; p < std::min(lint.places.size(), kMax); ++p) {
            print_line("    '%s' at %s", lint.places[p].node.c_str(),
                       engine::fixed(lint.places[p].at).c_str());
        }
        if (lint.places.size() > kMax) {
            print_line("    and %zu more: see --json", lint.places.size() - kMax);
        }
    }
}

}  // namespace campuswalk::tools
