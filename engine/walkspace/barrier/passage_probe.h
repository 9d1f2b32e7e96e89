#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/walkspace/barrier/why_not.h"

namespace campuswalk::engine {

/// A way that a changed body found.
struct FoundPath {
    GroundState start;                  ///< where it left what the body reaches
    std::vector<collision::Vec3> feet;  ///< from there on
    double length = 0.0;                ///< of that, metres
};

/// Walks through a passage with a changed body, or in a changed world.
class PassageProbe {
public:
    /// All of them must outlive it.
    PassageProbe(const WorkerWorlds& worlds, const ExploreSettings& settings, const PassageQuery& query);

    const PassageQuery& query() const { return query_; }
    const collision::MoverSettings& body() const { return settings_.strides.body; }
    const collision::QueryFilter& solids() const { return settings_.solids; }
    const collision::World& world() const { return worlds_[0]; }
    /// What the last search touched.
    const std::vector<collision::ObjectId>& touched() const { return touched_; }
    /// Whether the searches have reached so much that no other change is tried.
    bool is_exhausted() const;

    std::optional<FoundPath> find_path_as_it_is();
    std::optional<FoundPath> find_path(const collision::MoverSettings& body) {
        return find_path(body, query_.from);
    }
    std::optional<FoundPath> find_path(const collision::MoverSettings& body,
                                       std::span<const GroundState> from) {
        return find_path_in(worlds_, body, from);
    }
    std::optional<FoundPath> find_path_without(collision::ObjectId object);
    std::optional<FoundPath> find_path_in(const collision::World& changed) {
        return find_path_in(WorkerWorlds(changed, 1, {}), body(), query_.from);
    }

    /// Sends the body along the way of the changed one: what it is stopped by is the barrier.
    void locate(const FoundPath& path, Barrier& barrier) const;

private:
    std::optional<FoundPath> find_path_in(const WorkerWorlds& worlds, const collision::MoverSettings& body,
                                          std::span<const GroundState> from);

    const WorkerWorlds& worlds_;
    ExploreSettings settings_;
    const PassageQuery& query_;
    std::vector<bool> disabled_;
    std::vector<collision::ObjectId> touched_;
    std::size_t nodes_in_all_ = 0;
};

}  // namespace campuswalk::engine
