#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/model/model.h"

namespace campuswalk::scene {

struct NodeReport {
    std::string name;
    int parent = -1;            ///< index into ModelReport::nodes
    int depth = 0;              ///< 0 at the root
    std::size_t triangles = 0;  ///< of its own meshes, without its children's
    Bounds bounds;              ///< world, of its whole subtree
};

struct MaterialReport {
    std::string name;
    std::string texture;        ///< as the file names it, empty for none
    std::size_t triangles = 0;  ///< as drawn
    AlphaMode alpha_mode = AlphaMode::opaque;
    bool double_sided = false;
};

struct TextureReport {
    std::string name;
    int width = 0;
    int height = 0;
};

/// Something that a person should look at. `code` is stable:
///   no-triangles     nothing to walk on
///   odd-scale        under half a metre or over 5 km across; with a unit that would make it a campus
///   coarse-position  so far from the file's origin that float32 steps exceed 5 mm
///   far-from-origin  over 10 km from the world's origin
///   z-up             lies like a map seen from the front: `up: z` is probably meant
///   mirrored-node    nodes with a negative determinant (drawn and collided right side out)
///   unnamed-node     nodes with triangles that no glob can name in a stable way
///   repeated-name    names that several nodes with triangles share
///   duplicate-faces  triangles that lie on another one, facing the same way
///   outlier          a few triangles stretch the bounds to four times what the rest fills
///   no-ground        nothing to walk on but shreds, tops of walls or a roof
///   solid-door       doors that close a way through
///   door-size        doors that are no door's size, or lie on the ground
///   stair-riser      stairs with steps that nobody climbs
struct ModelLint {
    struct Place {
        std::string node;
        Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< world
    };

    std::string code;
    std::string message;
    std::vector<Place> places = {};  ///< all of them, where there are any
};

/// What there is to say about a model, as plain data; printing it is the caller's.
struct ModelReport {
    std::string file;
    std::size_t meshes = 0;      ///< distinct ones
    std::size_t placements = 0;  ///< meshes as drawn
    std::size_t triangles = 0;   ///< as drawn
    std::size_t vertices = 0;    ///< of the distinct meshes
    Bounds bounds;
    std::optional<GeographicPlace> geographic;
    std::vector<NodeReport> nodes;
    std::vector<MaterialReport> materials;
    std::vector<TextureReport> textures;
    std::vector<ModelLint> warnings;
};

ModelReport report(const Model& model);

/// The warnings alone, of what the report tells else.
std::vector<ModelLint> find_lints(const Model& model, const ModelReport& report);

/// The lint `solid-door`, of one door or more.
ModelLint solid_doors(std::vector<ModelLint::Place> doors);

/// Whether an importer made the name up, where the file has none: it changes when the file does.
bool is_generated_name(const std::string& name);

/// Indices of the nodes that stretch the model's bounds to four times (along some axis) what 99 % of its
/// triangles fill.
std::vector<std::size_t> outlier_nodes(const Model& model);

/// Triangles of a node that have the corners of an earlier one in the same turning direction.
struct DuplicateFaces {
    std::size_t node = 0;
    std::size_t count = 0;
    Eigen::Vector3d first = Eigen::Vector3d::Zero();  ///< world, the middle of the first of them
};

/// By node, those that have any.
std::vector<DuplicateFaces> find_duplicate_faces(const Model& model, const Bounds& bounds);

}  // namespace campuswalk::scene
