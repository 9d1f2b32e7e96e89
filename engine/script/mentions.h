#pragma once

#include <string>

#include <Eigen/Core>

#include "scene/base/diagnostic.h"

// What steps and expectations name: events, objects, places.

namespace campuswalk::engine {

using scene::SourceMark;

/// `KIND OBJECT` with globs in both, as in "popup.open library" or "collision.* bench/*".
/// A pattern without an object matches any.
struct EventPattern {
    SourceMark mark;
    std::string kind;
    std::string object = "*";
};

/// A glob over the names of objects or buildings.
struct NamePattern {
    SourceMark mark;
    std::string glob = "*";
};

/// A point to go to. If it has no height (`[x, z]`), only the horizontal distance counts.
/// Resolved by the loader: `label` is what the user wrote (a place's name, or the coordinates).
struct Target {
    std::string label;
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    bool has_height = false;
};

/// Events that must be possible on the campus for a step or expectation to make sense.
struct Mention {
    EventPattern event;
    std::string if_unknown;  ///< the message if they aren't; empty: a general one
};

inline Mention mention_of_popup(const NamePattern& building) {
    return {{building.mark, "popup.open", building.glob}, "no building '" + building.glob + "' has a pop-up"};
}
inline Mention mention_of_solid(const NamePattern& object) {
    return {{object.mark, "collision.enter", object.glob},
            "the campus has no solid object '" + object.glob + "'"};
}

}  // namespace campuswalk::engine
