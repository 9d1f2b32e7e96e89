// The files of the cache and the answer of the import helper, with a correct length and checksum, as a forger
// would write them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "collision/mesh/mesh_collider.h"
#include "collision/mesh/mesh_query.h"
#include "engine/walkspace/report/report_file.h"
#include "scene/base/checksum.h"
#include "scene/cache/tree_file.h"
#include "scene/campus/bake_mesh.h"
#include "scene/campus/node_selection.h"
#include "scene/import/helper/import_protocol.h"
#include "scene/model/model_file.h"
#include "tests/fuzz/targets/targets.h"

namespace campuswalk::fuzz {

namespace {

/// Asks what a walk asks.
void query(const collision::MeshCollider& collider) {
    using collision::Vec3;
    std::vector<std::uint32_t> near;
    for (const Vec3& end : {Vec3(0, -20, 0), Vec3(15, 3, -12), Vec3(1e5, 1, 1e5)}) {
        first_on_ray(collider, {Vec3(0.1, 20, 0.2), end});
        triangles_near(collider, {end, end + Vec3(0, 1.8, 0)}, 3.0, near);
    }
    for (const std::uint32_t triangle : near) {
        if (triangle >= collider.mesh().triangles.size()) {
            throw std::logic_error("a query names a triangle that doesn't exist");
        }
    }
}

/// What a campus makes of a model.
void use(const scene::Model& model) {
    for (const scene::Texture& texture : model.textures) {
        if (texture.rgba.size() !=
            4 * static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height)) {
            throw std::logic_error("a texture lacks pixels");
        }
    }
    std::vector<scene::NodeRef> roots;
    for (std::size_t n = 0; n < model.nodes.size(); ++n) {
        if (model.nodes[n].parent < 0) {
            roots.push_back({0, n});
        }
    }
    try {
        scene::BakedMesh baked = scene::bake_mesh(scene::gather_geometry({model}, {roots, {}}));
        if (!baked.mesh.triangles.empty()) {
            query(collision::MeshCollider(std::move(baked.mesh)));
        }
    } catch (const std::invalid_argument&) {  // too far away for a collider
    }
}

void read_model(Bytes bytes) {
    try {
        use(scene::read_model_file(forged(scene::kModelFile, bytes)).model);
    } catch (const scene::DamagedFile&) {
    }
}

void read_trees(Bytes bytes) {
    try {
        for (const scene::PlacedMesh& mesh : scene::read_tree_file(forged(scene::kTreeFile, bytes))) {
            query(*mesh.collider);
        }
    } catch (const scene::DamagedFile&) {
    }
}

/// Of the helper, which answers with errors as well.
void read_answer(Bytes bytes) {
    try {
        use(scene::read_response(forged(scene::kModelFile, bytes)).model);
    } catch (const scene::DamagedFile&) {
    } catch (const scene::InputError&) {
    }
}

/// Of a campus of three objects.
void read_report(Bytes bytes) {
    try {
        const engine::WalkReport report = engine::read_report_file(forged(engine::kReportFile, bytes), 3);
        for (std::uint32_t tile = 0; tile < report.space.tiles.size(); ++tile) {
            for (std::size_t number = 0; number < report.space.tiles[tile].nodes.size(); ++number) {
                const engine::WalkNodeId node{tile, static_cast<std::uint16_t>(number)};
                if (report.storeys.of(node) >= report.storeys.list.size()) {
                    std::abort();
                }
                report.space.parent(node);
            }
        }
    } catch (const scene::DamagedFile&) {
    }
}

/// Whole files, whose header may be damaged as well.
void read_archive(Bytes bytes) {
    const auto whole = std::as_bytes(bytes);
    try {
        scene::read_model_file(whole);
    } catch (const scene::DamagedFile&) {
    }
    try {
        scene::read_tree_file(whole);
    } catch (const scene::DamagedFile&) {
    }
}

constexpr std::array kTargets = {Target{"model-file", read_model}, Target{"tree-file", read_trees},
                                 Target{"import-answer", read_answer}, Target{"walk-space", read_report},
                                 Target{"archive", read_archive}};

}  // namespace

std::span<const Target> archive_targets() {
    return kTargets;
}

}  // namespace campuswalk::fuzz
