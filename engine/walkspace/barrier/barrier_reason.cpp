#include "engine/walkspace/barrier/barrier_reason.h"

#include <algorithm>

#include "engine/events/decimals.h"
#include "scene/campus/node_at.h"
#include "scene/campus/node_selection.h"
#include "scene/model/name_words.h"

namespace campuswalk::engine {

namespace {

/// Its letters and digits: objects are often called after their nodes, "hedge/hedge-04" after "hedge_04".
std::string letters_of(std::string name) {
    std::erase_if(name, [](char c) { return c == '_' || c == '-' || c == '/' || c == '.' || c == ' '; });
    return name;
}

/// The object's node there, if its name says more than the object's; else empty.
std::string telling_node(const scene::Campus& campus, collision::ObjectId object, const collision::Vec3& at) {
    const scene::CampusObject& named = campus.objects[index_of(object)];
    const std::string node = scene::node_at(campus, named, at);
    const bool says_more =
        !scene::is_generated_name(node) && !letters_of(named.id).ends_with(letters_of(node));
    return says_more ? node : "";
}

bool consists_of_parts(ReasonKind kind) {
    return kind == ReasonKind::several || kind == ReasonKind::sequence;
}

/// Of an opening, the other change that would do as well there: to take an object away; and the reverse.
std::optional<ReasonKind> alternative_to(ReasonKind kind) {
    return kind == ReasonKind::opening  ? std::optional(ReasonKind::object)
           : kind == ReasonKind::object ? std::optional(ReasonKind::opening)
                                        : std::nullopt;
}

/// A barrier by itself.
Reason single_reason(const scene::Campus& campus, const Barrier& barrier) {
    Reason reason;
    if (barrier.object) {
        reason = reason_about(barrier.kind, campus, *barrier.object, barrier.at);
        const scene::CampusObject& object = campus.objects[index_of(*barrier.object)];
        reason.is_node = barrier.kind == ReasonKind::object &&
                         (barrier.is_node || scene::nodes_of(campus.models, object.nodes).size() <= 1);
    }
    reason.kind = barrier.kind;
    reason.at = barrier.at;
    if (has_measure(barrier.kind)) {
        const bool is_angle = barrier.kind == ReasonKind::slope;
        reason.measured = is_angle ? degrees(barrier.measured) : barrier.measured;
        if (barrier.kind != ReasonKind::ledge && barrier.kind != ReasonKind::gap) {
            reason.allowed = is_angle ? degrees(barrier.allowed) : barrier.allowed;
        }
    }
    if (barrier.kind == ReasonKind::gap) {
        reason.from = barrier.from;
    }
    return reason;
}

}  // namespace

bool has_measure(ReasonKind kind) {
    return kind != ReasonKind::object && kind != ReasonKind::several && kind != ReasonKind::sequence &&
           kind != ReasonKind::solid;
}

Reason reason_about(ReasonKind kind, const scene::Campus& campus, collision::ObjectId object,
                    const collision::Vec3& at) {
    Reason reason{.kind = kind, .object = campus.objects[index_of(object)].id};
    reason.node = telling_node(campus, object, at);
    reason.at = at;
    return reason;
}

std::string object_text(const scene::Campus& campus, collision::ObjectId object, const collision::Vec3& at) {
    return object_text(reason_about(ReasonKind::object, campus, object, at));
}

Reason reason_of(const scene::Campus& campus, const Barrier& barrier) {
    constexpr double kBeside = 2.0;  // metres: farther off, it is another way in
    Reason reason = single_reason(campus, barrier);
    if (consists_of_parts(barrier.kind)) {
        for (const Barrier& part : barrier.parts) {
            reason.parts.push_back(reason_of(campus, part));
        }
    } else if (const auto alternative = alternative_to(barrier.kind)) {
        const auto part = std::ranges::find_if(barrier.parts, [&](const Barrier& each) {
            return each.kind == *alternative && (each.at - barrier.at).norm() <= kBeside;
        });
        if (part != barrier.parts.end()) {
            reason.parts.push_back(single_reason(campus, *part));
        }
    }
    return reason;
}

}  // namespace campuswalk::engine
