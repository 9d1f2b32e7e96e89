#pragma once

#include <vector>

#include "engine/walkspace/barrier/passage_probe.h"
#include "engine/walkspace/barrier/smallest_change.h"

namespace campuswalk::engine {

/// Looks for an object, or a node of a mesh, without which the body would get through.
class ObstacleRemover {
public:
    /// `probe` must outlive it.
    explicit ObstacleRemover(PassageProbe& probe) : probe_(probe) {}

    /// Adds those of the touched objects that don't carry the body.
    void try_objects(std::vector<collision::ObjectId> touched, std::vector<Change>& found);
    /// Adds a node near the starts, no larger than this; it says more than the object that it is part of.
    void try_nodes(double largest, std::vector<Change>& found);

private:
    bool carries_a_start(collision::ObjectId id) const;
    Change without(collision::ObjectId id, const FoundPath& path) const;
    double whole_length(const FoundPath& path) const;

    PassageProbe& probe_;
};

}  // namespace campuswalk::engine
