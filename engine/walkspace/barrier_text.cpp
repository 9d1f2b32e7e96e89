#include "engine/walkspace/barrier_text.h"

#include <algorithm>

#include "engine/events/decimals.h"
#include "scene/campus/node_at.h"
#include "scene/campus/node_selection.h"
#include "scene/model/name_words.h"

namespace campuswalk::engine {

namespace {

struct Compared {
    std::string measured;
    std::string allowed;
};

/// The barrier's numbers with so many decimals that one sees which is greater, up to a tenth of a millimetre.
Compared compared(const Barrier& barrier) {
    Compared texts;
    for (int decimals = 2; decimals <= 4 && texts.measured == texts.allowed; ++decimals) {
        texts = {fixed(barrier.measured, decimals) + " m", fixed(barrier.allowed, decimals) + " m"};
    }
    return texts;
}

Compared compared_degrees(const Barrier& slope) {
    Compared texts;
    for (int decimals = 1; decimals <= 3 && texts.measured == texts.allowed; ++decimals) {
        texts = {fixed(degrees(slope.measured), decimals), fixed(degrees(slope.allowed), decimals)};
    }
    return texts;
}

std::string place_text(const scene::Campus& campus, const Barrier& barrier, const char* before) {
    const collision::Vec3& p = barrier.at;
    std::string text = before;
    if (barrier.object) {
        text += object_text(campus, *barrier.object, p) + ", ";
    }
    return text + coordinates_text(p);
}

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

/// The other change that would do as well there, if there is one of this kind.
const Barrier* part_of(const Barrier& barrier, BarrierKind kind) {
    constexpr double kBeside = 2.0;  // metres: farther off, it is another way in
    const auto found = std::ranges::find_if(barrier.parts, [&](const Barrier& part) {
        return part.kind == kind && (part.at - barrier.at).norm() <= kBeside;
    });
    return found == barrier.parts.end() ? nullptr : &*found;
}

std::string opening_text(const Barrier& opening) {
    const auto [measured, allowed] = compared(opening);
    return "is " + measured + " wide, the body needs " + allowed;
}

/// What it is, of those whose sentence goes on with what the body manages or needs.
std::string measure_text(const scene::Campus& campus, const Barrier& barrier) {
    switch (barrier.kind) {
        case BarrierKind::riser:
            return "riser of " + compared(barrier).measured + place_text(campus, barrier, " at ");
        case BarrierKind::slope:
            return "slope of " + compared_degrees(barrier).measured + " degrees" +
                   place_text(campus, barrier, " at ");
        case BarrierKind::headroom:
            return "headroom of " + compared(barrier).measured + place_text(campus, barrier, " under ");
        default:
            return "";
    }
}

std::string blocking_object_text(const scene::Campus& campus, const Barrier& object, const Barrier* opening) {
    const scene::CampusObject& named = campus.objects[index_of(*object.object)];
    const bool is_whole = object.is_node || scene::nodes_of(campus.models, named.nodes).size() <= 1;
    std::string text;
    if (is_whole) {
        text = object_text(campus, *object.object, object.at) + " stands in the way at ";
    } else {  // to take away the node alone wouldn't help
        const std::string node = telling_node(campus, *object.object, object.at);
        text = named.id + " stands in the way at " + (node.empty() ? "" : node + ", ");
    }
    text += coordinates_text(object.at);
    if (opening != nullptr) {
        text += "; the opening beside it " + opening_text(*opening);
    }
    return text;
}

std::string several_text(const scene::Campus& campus, const Barrier& barrier) {
    std::string text;
    for (const Barrier& part : barrier.parts) {
        text += (text.empty() ? "" : ", and ") + barrier_text(campus, part);
    }
    return text;
}

/// In order; what the body manages is said once of barriers of one kind.
std::string sequence_text(const scene::Campus& campus, const Barrier& barrier) {
    std::string text;
    for (std::size_t i = 0; i < barrier.parts.size(); ++i) {
        const Barrier& part = barrier.parts[i];
        const bool goes_on = i + 1 < barrier.parts.size() && barrier.parts[i + 1].kind == part.kind;
        const std::string measure = goes_on ? measure_text(campus, part) : "";
        text += measure.empty() ? barrier_text(campus, part) : measure;
        if (i + 1 < barrier.parts.size()) {
            text += measure.empty() ? "; then " : ", then ";
        }
    }
    return text;
}

}  // namespace

const char* name_of(BarrierKind kind) {
    switch (kind) {
        case BarrierKind::riser:
            return "riser";
        case BarrierKind::ledge:
            return "ledge";
        case BarrierKind::slope:
            return "slope";
        case BarrierKind::opening:
            return "opening";
        case BarrierKind::headroom:
            return "headroom";
        case BarrierKind::object:
            return "object";
        case BarrierKind::several:
            return "several";
        case BarrierKind::solid:
            return "solid";
        case BarrierKind::gap:
            return "gap";
        case BarrierKind::sequence:
            return "sequence";
    }
    return "";
}

std::string object_text(const scene::Campus& campus, collision::ObjectId object, const collision::Vec3& at) {
    const std::string& id = campus.objects[index_of(object)].id;
    const std::string node = telling_node(campus, object, at);
    return node.empty() ? id : id + " (" + node + ")";
}

std::string barrier_text(const scene::Campus& campus, const Barrier& barrier) {
    switch (barrier.kind) {
        case BarrierKind::riser:
            return measure_text(campus, barrier) + "; the avatar steps " + compared(barrier).allowed;
        case BarrierKind::ledge:
            return "ledge of " + fixed(barrier.measured, 2) + " m" + place_text(campus, barrier, " at ") +
                   "; no way up";
        case BarrierKind::slope:
            return measure_text(campus, barrier) + "; the avatar walks up " +
                   compared_degrees(barrier).allowed;
        case BarrierKind::opening:
            if (const Barrier* object = part_of(barrier, BarrierKind::object)) {
                return blocking_object_text(campus, *object, &barrier);
            }
            return place_text(campus, barrier, "the opening at ") + " " + opening_text(barrier);
        case BarrierKind::headroom:
            return measure_text(campus, barrier) + "; the body needs " + compared(barrier).allowed;
        case BarrierKind::object:
            return blocking_object_text(campus, barrier, part_of(barrier, BarrierKind::opening));
        case BarrierKind::several:
            return several_text(campus, barrier);
        case BarrierKind::sequence:
            return sequence_text(campus, barrier);
        case BarrierKind::gap:
            return "a gap of " + fixed(barrier.measured, 1) + " m from " + coordinates_text(barrier.from) +
                   " to " + place_text(campus, barrier, "") + "; there is nothing to walk on between";
        case BarrierKind::solid:
            return "closed off: none of the changes that were tried gets there";
    }
    return "";
}

}  // namespace campuswalk::engine
