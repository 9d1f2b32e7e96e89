#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "engine/walkspace/space/node_numbers.h"
#include "engine/walkspace/space/walk_space.h"

namespace campuswalk::engine {

/// A part of a space: nodes between which one can walk back wherever one came from. The number of the first.
using Part = std::uint32_t;

/// The parts of a space, which must outlive them.
class Parts {
public:
    explicit Parts(const WalkSpace& space);

    Part of(const WalkNodeId& node) const { return part_of_[numbers_(node)]; }
    /// Of the node that the stride ended at.
    std::optional<Part> at(const StrideEnd& end) const;

    template <typename Visit>
    void for_each_node(const Visit& visit) const {
        numbers_.for_each(visit);
    }
    /// Calls `visit(from, to)` for those that the space was explored by.
    template <typename Visit>
    void for_each_stride(const Visit& visit) const {
        numbers_.for_each([&](const WalkNodeId& to) {
            if (const auto from = space_.parent(to)) {
                visit(*from, to);
            }
        });
    }

private:
    const WalkSpace& space_;
    NodeNumbers numbers_;
    std::vector<Part> part_of_;  ///< by node number
};

/// From which parts one can walk home to a start, as far as it is known what leads where.
class PathsHome {
public:
    /// What the strides tell that the space was explored by.
    PathsHome(const WalkSpace& space, const Parts& parts);

    bool lead_from(Part part) const { return home_.contains(part); }
    /// One can walk from one part into the other.
    void add(Part from, Part into);

    /// Calls `visit(from, into)` for what leads from one part that doesn't lead home into another.
    template <typename Visit>
    void for_each_other(const Visit& visit) const {
        for (const auto& [into, sources] : sources_) {
            for (const Part from : sources) {
                if (!lead_from(from)) {
                    visit(from, into);
                }
            }
        }
    }

private:
    void mark_home(Part part);

    std::set<Part> home_;
    std::map<Part, std::set<Part>> sources_;  ///< of each part: those that lead into it
};

}  // namespace campuswalk::engine
