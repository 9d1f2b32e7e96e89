#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/base/diagnostic.h"
#include "scene/campus/campus_description.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

/// A node of one of a campus' models.
struct NodeRef {
    std::size_t model = 0;
    std::size_t node = 0;

    friend auto operator<=>(const NodeRef&, const NodeRef&) = default;
};

/// The nodes that match a glob, without those below another match, since a node stands for its subtree. In
/// the order of the scene files, then of the nodes.
std::vector<NodeRef> topmost_matches(const std::vector<Model>& models, std::span<const NodeGlob> globs);

/// Subtrees, without some of their own subtrees.
struct NodeSelection {
    std::vector<NodeRef> roots;   ///< each with its subtree
    std::vector<NodeRef> except;  ///< likewise, left out of those; ascending
};

/// Selects the nodes of a campus file by its globs. Globs and names may be any stranger's: each function
/// throws InputError `too-large`, at the glob, once all calls together have compared more than so many
/// characters.
class NodeSelector {
public:
    static constexpr std::uint64_t kMaxCompared = 30'000'000'000;  // a minute or two

    explicit NodeSelector(const std::vector<Model>& models, std::uint64_t max_compared = kMaxCompared)
        : models_(models), max_compared_(max_compared) {}

    /// The nodes that match `globs` without those that match `except`; no root is in a subtree that is left
    /// out.
    NodeSelection select(std::span<const NodeGlob> globs, std::span<const NodeGlob> except);

    /// Reports every glob that matches no node's name (`no-node`, at the glob), with the nearest name.
    void check(std::span<const NodeGlob> globs, DiagnosticList& diagnostics);

private:
    bool matches(const NodeGlob& glob, const Node& node);
    std::string suggestion(const std::string& pattern);

    const std::vector<Model>& models_;
    std::uint64_t max_compared_;
    std::uint64_t compared_ = 0;
    int suggestions_ = 0;
    std::vector<std::string> names_;  ///< of all nodes, once a suggestion needs them: distinct, ascending
};

/// All nodes of the roots' subtrees except those left out, root by root; parents come first.
std::vector<NodeRef> nodes_of(const std::vector<Model>& models, const NodeSelection& selection);

/// The triangles of some subtrees in world coordinates.
struct WorldGeometry {
    std::vector<Eigen::Vector3d> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

WorldGeometry gather_geometry(const std::vector<Model>& models, const NodeSelection& selection);

}  // namespace campuswalk::scene
