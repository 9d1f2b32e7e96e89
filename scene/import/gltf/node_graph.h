#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "scene/import/gltf/accessors.h"
#include "scene/import/gltf/document.h"
#include "scene/import/gltf/primitives.h"
#include "scene/import/source/model_source.h"

namespace campuswalk::scene::gltf {

/// What was ignored or changed in the hierarchy, for warnings.
struct GraphNotes {
    std::size_t ignored_scenes = 0;
    std::size_t unplaced_meshes = 0;   ///< not in the default scene: ignored
    std::size_t meshes_at_origin = 0;  ///< in no node: added at the origin
    std::size_t hidden = 0;  ///< nodes whose meshes KHR_node_visibility hides: neither drawn nor solid
};

/// Reads the nodes of the default scene. Without a default scene, reads everything: the nodes of all scenes,
/// or all nodes if there are no scenes, and meshes that no node draws, each in a node of its own.
/// EXT_mesh_gpu_instancing adds a child node per instance, named `NAME#1`, `NAME#2`, …. Several roots get a
/// common parent named `ROOT`; unnamed nodes are named `nodes[N]`. Morph targets have their default weights.
/// A mesh with a skin is where the joints put it, not its node (glTF 2.0, 3.7.3.3): the node is then placed
/// at the skin's first joint.
NodeTree read_node_graph(const Document& document, Primitives& primitives, Accessors& accessors,
                         const Eigen::Matrix4d& X_world_file, GraphNotes& notes);

}  // namespace campuswalk::scene::gltf
