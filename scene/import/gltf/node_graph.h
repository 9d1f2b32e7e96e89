#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "scene/import/gltf/accessors.h"
#include "scene/import/gltf/document.h"
#include "scene/import/gltf/primitives.h"
#include "scene/import/source/model_source.h"

namespace campuswalk::scene::gltf {

/// What the hierarchy says that the Model doesn't show.
struct GraphNotes {
    std::size_t scenes_left_out = 0;
    std::size_t meshes_left_out = 0;  ///< no node of the default scene draws them
    std::size_t meshes_placed = 0;    ///< no node draws them: put at the origin
    std::size_t skinned = 0;          ///< nodes whose mesh bones would move
};

/// The nodes of the default scene. A file that names none is a box of parts and is read whole: the nodes of
/// all scenes, or without scenes all nodes, and meshes that none of them draws, each under a node of its own.
/// EXT_mesh_gpu_instancing gives a node's copies nodes of their own below it, called `NAME#1`, `NAME#2`, ….
/// Several roots get a common one called `ROOT`; nodes without a name are called `nodes[N]`.
NodeTree read_node_graph(const Document& document, const Primitives& primitives, Accessors& accessors,
                         const Eigen::Matrix4d& X_world_file, GraphNotes& notes);

}  // namespace campuswalk::scene::gltf
