#include "scene/cache/tree_file.h"

#include <stdexcept>
#include <utility>

#include "collision/base/storage.h"
#include "collision/bvh8/bvh8.h"
#include "collision/mesh/closed_parts.h"

namespace campuswalk::scene {

using collision::Aabb;
using collision::Bvh8;
using collision::Bvh8Leaf;
using collision::Bvh8Node;
using collision::ClosedParts;
using collision::MeshCollider;
using collision::Storage;
using collision::TriangleMesh;
using collision::Vec3;

namespace {

constexpr std::size_t kMinMeshBytes = 160;

void put(ArchiveWriter& out, const Vec3& v) {
    out.put_all(std::span<const double>(v.data(), 3));
}

void put(ArchiveWriter& out, const PlacedMesh& placed) {
    const TriangleMesh& mesh = placed.collider->mesh();
    const Bvh8& tree = placed.collider->bvh8();
    const ClosedParts& closed = placed.collider->closed_parts();
    out.put_text(placed.object);
    put(out, placed.p_world_origin);
    out.put(std::uint64_t{placed.zero_area});
    out.put(std::uint64_t{placed.openings});
    out.put(std::uint64_t{placed.left_out});
    put(out, tree.outer.center);
    out.put(tree.outer.radius);
    out.put(static_cast<double>(tree.reach));
    put(out, closed.bounds().min);
    put(out, closed.bounds().max);
    out.put(std::uint64_t{mesh.positions.size()});
    out.put(std::uint64_t{mesh.triangles.size()});
    out.put(std::uint64_t{tree.nodes.size()});
    out.put(std::uint64_t{tree.leaves.size()});
    out.put(std::uint64_t{closed.members().size()});
    out.put_aligned(std::span(mesh.positions));
    out.put_aligned(std::span(mesh.triangles));
    out.put_aligned(std::span(tree.nodes));
    out.put_aligned(std::span(tree.leaves));
    out.put_aligned(std::span(closed.members()));
}

Vec3 take_vector(ArchiveReader& in) {
    Vec3 v;
    for (Eigen::Index k = 0; k < 3; ++k) {
        v[k] = in.take<double>();
    }
    return v;
}

/// Elements with one bool at offset `flag`. Another value than 0 or 1 would be undefined behaviour.
template <typename Element>
Storage<Element> take_flagged(ArchiveReader& in, std::uint64_t count, std::size_t flag) {
    Storage<Element> elements = in.take_aligned<Element>(count);
    // as_const: non-const access to Storage copies.
    const std::span<const std::byte> bytes = std::as_bytes(std::span(std::as_const(elements)));
    std::byte seen{};
    for (std::size_t at = flag; at < bytes.size(); at += sizeof(Element)) {
        seen |= bytes[at];
    }
    if (std::to_integer<unsigned>(seen) > 1) {
        throw DamagedFile("a flag in it is out of range");
    }
    return elements;
}

PlacedMesh take_mesh(ArchiveReader& in) {
    PlacedMesh placed;
    placed.object = in.take_text();
    placed.p_world_origin = take_vector(in);
    placed.zero_area = in.take<std::uint64_t>();
    placed.openings = in.take<std::uint64_t>();
    placed.left_out = in.take<std::uint64_t>();
    Bvh8 tree;
    tree.outer.center = take_vector(in);
    tree.outer.radius = in.take<double>();
    tree.reach = static_cast<float>(in.take<double>());
    Aabb closed;
    closed.min = take_vector(in);
    closed.max = take_vector(in);
    const auto positions = in.take<std::uint64_t>();
    const auto triangles = in.take<std::uint64_t>();
    const auto nodes = in.take<std::uint64_t>();
    const auto leaves = in.take<std::uint64_t>();
    const auto members = in.take<std::uint64_t>();
    TriangleMesh mesh;
    mesh.positions = in.take_aligned<Eigen::Vector3f>(positions);
    mesh.triangles = in.take_aligned<std::array<std::uint32_t, 3>>(triangles);
    tree.nodes = take_flagged<Bvh8Node>(in, nodes, offsetof(Bvh8Node, rotated));
    tree.leaves = take_flagged<Bvh8Leaf>(in, leaves, offsetof(Bvh8Leaf, exact));
    Storage<std::uint64_t> inside = in.take_aligned<std::uint64_t>(members);
    if (!placed.p_world_origin.allFinite()) {
        throw DamagedFile("a mesh in it has no position");
    }
    try {
        ClosedParts parts(std::move(inside), closed, mesh.triangles.size());
        placed.collider =
            std::make_shared<const MeshCollider>(std::move(mesh), std::move(tree), std::move(parts));
    } catch (const std::invalid_argument& fault) {
        throw DamagedFile(fault.what());
    }
    return placed;
}

}  // namespace

ArchiveWriter archive_trees(std::span<const PlacedMesh> meshes) {
    ArchiveWriter out(kTreeFile);
    out.put(std::uint64_t{meshes.size()});
    for (const PlacedMesh& placed : meshes) {
        put(out, placed);
    }
    return out;
}

std::vector<PlacedMesh> read_tree_file(std::span<const std::byte> bytes, std::shared_ptr<const void> owner) {
    ArchiveReader in(bytes, kTreeFile, std::move(owner));
    std::vector<PlacedMesh> meshes(in.take_count(kMinMeshBytes));
    for (PlacedMesh& placed : meshes) {
        placed = take_mesh(in);
    }
    in.finish();
    return meshes;
}

}  // namespace campuswalk::scene
