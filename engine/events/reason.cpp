#include "engine/events/reason.h"

#include <array>
#include <cassert>
#include <utility>

#include "engine/events/decimals.h"

namespace campuswalk::engine {

namespace {

// In the order of ReasonKind.
constexpr std::array kReasonNames = {
    std::pair{ReasonKind::riser, "riser"},
    std::pair{ReasonKind::ledge, "ledge"},
    std::pair{ReasonKind::slope, "slope"},
    std::pair{ReasonKind::opening, "opening"},
    std::pair{ReasonKind::headroom, "headroom"},
    std::pair{ReasonKind::object, "object"},
    std::pair{ReasonKind::several, "several"},
    std::pair{ReasonKind::solid, "solid"},
    std::pair{ReasonKind::gap, "gap"},
    std::pair{ReasonKind::sequence, "sequence"},
    std::pair{ReasonKind::contact, "contact"},
    std::pair{ReasonKind::edge, "edge"},
    std::pair{ReasonKind::enclosed, "enclosed"},
    std::pair{ReasonKind::inside, "inside"},
    std::pair{ReasonKind::no_ground, "no_ground"},
    std::pair{ReasonKind::ground_far_below, "ground_far_below"},
    std::pair{ReasonKind::no_room, "no_room"},
    std::pair{ReasonKind::no_nearer, "no_nearer"},
    std::pair{ReasonKind::avoided, "avoided"},
    std::pair{ReasonKind::avoided_objects, "avoided_objects"},
    std::pair{ReasonKind::avoided_circle, "avoided_circle"},
    std::pair{ReasonKind::through, "through"},
    std::pair{ReasonKind::unsearched, "unsearched"},
    std::pair{ReasonKind::falls_out, "falls_out"},
    std::pair{ReasonKind::does_not_fit, "does_not_fit"},
};

struct Compared {
    std::string measured;
    std::string allowed;
};

/// The two numbers with so many decimals that one sees which is greater, up to a tenth of a millimetre.
Compared compared(const Reason& reason) {
    Compared texts;
    for (int decimals = 2; decimals <= 4 && texts.measured == texts.allowed; ++decimals) {
        texts = {fixed(reason.measured.value_or(0.0), decimals) + " m",
                 fixed(reason.allowed.value_or(0.0), decimals) + " m"};
    }
    return texts;
}

Compared compared_degrees(const Reason& slope) {
    Compared texts;
    for (int decimals = 1; decimals <= 3 && texts.measured == texts.allowed; ++decimals) {
        texts = {fixed(slope.measured.value_or(0.0), decimals), fixed(slope.allowed.value_or(0.0), decimals)};
    }
    return texts;
}

std::string metres_text(const std::optional<double>& value, int decimals) {
    return fixed(value.value_or(0.0), decimals) + " m";
}

std::string at_text(const std::optional<Eigen::Vector3d>& place) {
    return place ? coordinates_text(*place) : "";
}

std::string place_text(const Reason& reason, const char* before) {
    return before + (reason.object.empty() ? "" : object_text(reason) + ", ") + at_text(reason.at);
}

/// The text, followed by where the reason's place is, unless it has none.
std::string with_place(const std::string& text, const Reason& reason) {
    return reason.at ? text + ", at " + coordinates_text(*reason.at) : text;
}

std::string opening_text(const Reason& opening) {
    const auto [measured, allowed] = compared(opening);
    return "is " + measured + " wide, the body needs " + allowed;
}

/// What it is, of those whose sentence goes on with what the body manages or needs.
std::string measure_text(const Reason& reason) {
    switch (reason.kind) {
        case ReasonKind::riser:
            return "riser of " + compared(reason).measured + place_text(reason, " at ");
        case ReasonKind::slope:
            return "slope of " + compared_degrees(reason).measured + " degrees" + place_text(reason, " at ");
        case ReasonKind::headroom:
            return "headroom of " + compared(reason).measured + place_text(reason, " under ");
        default:
            return "";
    }
}

std::string blocking_object_text(const Reason& object, const Reason* opening) {
    std::string text;
    if (object.is_node) {
        text = object_text(object) + " stands in the way at ";
    } else {  // to take away the node alone wouldn't help
        text = object.object + " stands in the way at " + (object.node.empty() ? "" : object.node + ", ");
    }
    text += at_text(object.at);
    if (opening != nullptr) {
        text += "; the opening beside it " + opening_text(*opening);
    }
    return text;
}

std::string several_text(const Reason& several) {
    std::string text;
    for (const Reason& part : several.parts) {
        text += (text.empty() ? "" : ", and ") + text_of(part);
    }
    return text;
}

/// In order; what the body manages is said once of barriers of one kind.
std::string sequence_text(const Reason& sequence) {
    std::string text;
    for (std::size_t i = 0; i < sequence.parts.size(); ++i) {
        const Reason& part = sequence.parts[i];
        const bool goes_on = i + 1 < sequence.parts.size() && sequence.parts[i + 1].kind == part.kind;
        const std::string measure = goes_on ? measure_text(part) : "";
        text += measure.empty() ? text_of(part) : measure;
        if (i + 1 < sequence.parts.size()) {
            text += measure.empty() ? "; then " : ", then ";
        }
    }
    return text;
}

std::string enclosed_text(const Reason& reason) {
    std::string text = object_text(reason) + " encloses the avatar";
    if (!reason.parts.empty()) {
        text += ": " + text_of(reason.parts.front());
    }
    return text + (reason.room ? "; the nearest room is " + metres_text(reason.measured, 2) + " away at " +
                                     coordinates_text(*reason.room)
                               : "; there is no room within " + metres_text(reason.allowed, 0));
}

std::string no_nearer_text(const Reason& reason) {
    const std::string text =
        "one gets no nearer than " + metres_text(reason.measured, 2) + ", to " + at_text(reason.at);
    return reason.object.empty() ? text : text + ": " + object_text(reason) + " is in the way";
}

std::string avoided_text(const Reason& reason) {
    std::string text = "every way leads through what is to be avoided: ";
    for (std::size_t i = 0; i < reason.parts.size(); ++i) {
        const bool is_last = i + 1 == reason.parts.size() && reason.more == 0;
        text += (i == 0 ? "" : is_last ? " or " : ", ") + text_of(reason.parts[i]);
    }
    return reason.more == 0 ? text : text + " or " + std::to_string(reason.more) + " more";
}

std::string avoided_objects_text(const std::string& glob) {
    const bool is_pattern = glob.find_first_of("*?[") != std::string::npos;
    return (is_pattern ? "objects '" : "object '") + glob + "'";
}

std::string through_text(const Reason& reason) {
    std::string text = "the way goes through " + reason.name;
    for (const Reason& part : reason.parts) {
        text += (is_unsearched(part) ? ": " : ", and that can't be reached: ") + text_of(part);
    }
    return text;
}

}  // namespace

std::string_view name_of(ReasonKind kind) {
    const auto& [named, name] = kReasonNames[static_cast<std::size_t>(kind)];
    assert(named == kind);
    static_cast<void>(named);
    return name;
}

std::vector<ReasonKind> reason_kinds() {
    std::vector<ReasonKind> kinds;
    kinds.reserve(kReasonNames.size());
    for (const auto& [kind, name] : kReasonNames) {
        kinds.push_back(kind);
    }
    return kinds;
}

std::optional<Eigen::Vector3d> look_at(const Reason& reason) {
    if (reason.kind == ReasonKind::through && !reason.parts.empty()) {
        return look_at(reason.parts.front());
    }
    return reason.look_at ? reason.look_at : reason.at;
}

bool is_unsearched(const Reason& reason) {
    return reason.kind == ReasonKind::unsearched ||
           (reason.kind == ReasonKind::through && !reason.parts.empty() &&
            is_unsearched(reason.parts.front()));
}

std::string object_text(const Reason& reason) {
    return reason.node.empty() ? reason.object : reason.object + " (" + reason.node + ")";
}

std::string text_of(const Reason& reason) {
    const Reason* const part = reason.parts.empty() ? nullptr : &reason.parts.front();
    switch (reason.kind) {
        case ReasonKind::riser:
            return measure_text(reason) + "; the avatar steps " + compared(reason).allowed;
        case ReasonKind::ledge:
            return "ledge of " + metres_text(reason.measured, 2) + place_text(reason, " at ") + "; no way up";
        case ReasonKind::slope:
            return measure_text(reason) + "; the avatar walks up " + compared_degrees(reason).allowed;
        case ReasonKind::opening:
            return part != nullptr ? blocking_object_text(*part, &reason)
                                   : place_text(reason, "the opening at ") + " " + opening_text(reason);
        case ReasonKind::headroom:
            return measure_text(reason) + "; the body needs " + compared(reason).allowed;
        case ReasonKind::object:
            return blocking_object_text(reason, part);
        case ReasonKind::several:
            return several_text(reason);
        case ReasonKind::solid:
            return "closed off: none of the changes that were tried gets there";
        case ReasonKind::gap:
            return "a gap of " + metres_text(reason.measured, 1) + " from " + at_text(reason.from) + " to " +
                   place_text(reason, "") + "; there is nothing to walk on between";
        case ReasonKind::sequence:
            return sequence_text(reason);
        case ReasonKind::contact:
            return object_text(reason) + " is in the way at " + at_text(reason.at) +
                   (reason.detour ? "; " + metres_text(reason.detour, 1) + " lead round it" : "");
        case ReasonKind::edge:
            return "from the edge of " + object_text(reason) + " at a height of " +
                   metres_text(reason.at ? std::optional(reason.at->y()) : std::nullopt, 2);
        case ReasonKind::enclosed:
            return enclosed_text(reason);
        case ReasonKind::inside:
            return with_place("it is inside " + object_text(reason), reason);
        case ReasonKind::no_ground:
            return with_place("there is no ground below it", reason);
        case ReasonKind::ground_far_below:
            return with_place("the ground is " + metres_text(reason.measured, 2) + " below it", reason);
        case ReasonKind::no_room:
            return with_place("there is no room to stand", reason);
        case ReasonKind::no_nearer:
            return no_nearer_text(reason);
        case ReasonKind::avoided:
            return avoided_text(reason);
        case ReasonKind::avoided_objects:
            return avoided_objects_text(reason.name);
        case ReasonKind::avoided_circle:
            return "the circle of " + metres_text(reason.measured, 2) + " around " + reason.name;
        case ReasonKind::through:
            return through_text(reason);
        case ReasonKind::unsearched:
            return "the search ended after " + fixed(reason.measured.value_or(0.0), 0) +
                   " m² of ground, the most that is explored, and there is more";
        case ReasonKind::falls_out:
            return "the avatar falls out of the world";
        case ReasonKind::does_not_fit:
            return "the avatar doesn't fit at " + reason.name;
    }
    return "";
}

std::string text_of(const RouteHint& hint) {
    std::string text = "a route of " + fixed(hint.length, 1) + " m leads to " + hint.to;
    for (std::size_t i = 0; i < hint.by.size(); ++i) {
        text += (i == 0 ? " by [" : ", [") + fixed(hint.by[i].x(), 2) + ", " + fixed(hint.by[i].z(), 2) + "]";
    }
    return text + (hint.turns_again ? ", …" : "") + ": use go_to";
}

}  // namespace campuswalk::engine
