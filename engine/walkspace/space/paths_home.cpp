#include "engine/walkspace/space/paths_home.h"

#include <utility>

#include "collision/geometry/disjoint_sets.h"

namespace campuswalk::engine {

Parts::Parts(const WalkSpace& space) : space_(space), numbers_(space) {
    collision::DisjointSets sets(numbers_.count());
    for_each_stride([&](const WalkNodeId& from, const WalkNodeId& to) {
        if (space_.node(to).returns == 1) {
            sets.join(numbers_(to), numbers_(from));
        }
    });
    part_of_ = std::move(sets).roots();
}

std::optional<Part> Parts::at(const StrideEnd& end) const {
    const auto node = end.kind == StrideEnd::Kind::grounded
                          ? space_.find(space_.grid.cell_at(end.at.foot), end.at.foot.y())
                          : std::nullopt;
    return node ? std::optional(of(*node)) : std::nullopt;
}

PathsHome::PathsHome(const WalkSpace& space, const Parts& parts) {
    for (const WalkNodeId& start : space.starts) {
        home_.insert(parts.of(start));
    }
    parts.for_each_stride([&](const WalkNodeId& from, const WalkNodeId& to) {
        if (space.node(to).returns == 0) {  // else they are of one part
            add(parts.of(from), parts.of(to));
        }
    });
}

void PathsHome::add(Part from, Part into) {
    if (from == into || lead_from(from)) {
        return;
    }
    if (lead_from(into)) {
        mark_home(from);
    } else {
        sources_[into].insert(from);
    }
}

/// The part leads home, and so does every part that leads into it.
void PathsHome::mark_home(Part part) {
    std::vector<Part> marked{part};
    while (!marked.empty()) {
        const Part next = marked.back();
        marked.pop_back();
        if (home_.insert(next).second) {
            const std::set<Part>& sources = sources_[next];
            marked.insert(marked.end(), sources.begin(), sources.end());
        }
    }
}

}  // namespace campuswalk::engine
