#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/base/diagnostic.h"
#include "scene/lint/doors.h"
#include "scene/lint/flights.h"
#include "scene/model/model.h"

namespace campuswalk::scene {

struct NodeReport {
    std::string name;
    int parent = -1;            ///< index into ModelReport::nodes
    int depth = 0;              ///< 0 at the root
    std::size_t triangles = 0;  ///< of its own meshes
    std::vector<std::size_t>
        materials;  ///< of its own meshes, indices into ModelReport::materials, ascending
    Bounds bounds;  ///< world, of the subtree
};

struct MaterialReport {
    std::string name;
    std::string texture;        ///< as written in the file; empty for none
    std::size_t triangles = 0;  ///< as drawn
    AlphaMode alpha_mode = AlphaMode::opaque;
    bool double_sided = false;
};

struct TextureReport {
    std::string name;
    int width = 0;
    int height = 0;
};

/// A likely mistake in a model. `code` is stable:
///   no-triangles     nothing to walk on
///   odd-scale        all vertices lie at one point, or sizes are unusual (scene/frame)
///   coarse-position  so far from the file's origin that float32 spacing exceeds 5 mm
///   far-from-origin  over 10 km from the world's origin
///   z-up             it seems to lie on its back: `up: z` is probably missing (scene/frame)
///   mirrored-node    nodes with a negative determinant (their winding is corrected on import)
///   unnamed-node     nodes with triangles but no stable name for globs to match
///   repeated-name    names shared by several nodes with triangles
///   duplicate-faces  triangles with the same vertices and winding as another
///   outlier          a few nodes stretch the bounds to four times the extent of the rest
///   not-solid        what is drawn but nobody stands on: skies, water, boxes that openings were cut with
///   no-ground        nothing to walk on but fragments, tops of walls or a roof (by engine/walkspace)
///   solid-door       doors that block a doorway
///   door-size        doors of implausible height, or lying on the ground
///   stair-riser      stairs with risers too high to climb
struct ModelLint {
    struct Place {
        std::string node;
        Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< world
    };

    DiagnosticCode code;
    std::string message;
    std::vector<Place> places = {};  ///< empty if it concerns the model as a whole
};

/// Contents and statistics of a model; the caller prints them.
struct ModelReport {
    std::string file;
    std::size_t meshes = 0;      ///< unique
    std::size_t placements = 0;  ///< instances of meshes
    std::size_t triangles = 0;   ///< as drawn
    std::size_t vertices = 0;    ///< of the unique meshes
    Bounds bounds;
    std::optional<GeographicPlace> geographic;
    std::vector<NodeReport> nodes;
    std::vector<MaterialReport> materials;
    std::vector<TextureReport> textures;
    std::vector<Door> doors;
    std::vector<Flight> flights;  ///< of stairs
    std::vector<ModelLint> warnings;
};

ModelReport report(const Model& model);

/// Only what it says of the nodes.
std::vector<NodeReport> report_nodes(const Model& model);

/// What the import says that it left out or repaired becomes the report's first warnings.
void add_repairs(const std::vector<Diagnostic>& repairs, ModelReport& report);

/// Of all but the doors in doorways. `report`: all but the warnings, doors and flights are filled in.
std::vector<ModelLint> find_lints(const Model& model, const ModelReport& report);

/// The lint `solid-door`; `doors` is not empty.
ModelLint solid_doors(std::vector<ModelLint::Place> doors);

/// Indices of the nodes that stretch the bounds by three halves of the extent of 99 % of the triangles, or,
/// of what those lie within, by sixteen times as much.
std::vector<std::size_t> outlier_nodes(const Model& model);

/// Triangles of a node that have the same vertices and winding as an earlier triangle.
struct DuplicateFaces {
    std::size_t node = 0;
    std::size_t count = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< world, the centroid of the first of them
};

/// In order of nodes; nodes without duplicates are left out.
std::vector<DuplicateFaces> find_duplicate_faces(const Model& model, const Bounds& bounds);

}  // namespace campuswalk::scene
