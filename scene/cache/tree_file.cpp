#include "scene/cache/tree_file.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "collision/large_pages.h"
#include "collision/wide_tree.h"

namespace campuswalk::scene {

using collision::MeshCollider;
using collision::TriangleMesh;
using collision::Vec3;
using collision::WideLeaf;
using collision::WideNode;
using collision::WideTree;

namespace {

constexpr std::size_t kLeastMesh = 104;

void put(SealedWriter& out, const Vec3& v) {
    out.put_all(std::span<const double>(v.data(), 3));
}

void put(SealedWriter& out, const PlacedMesh& placed) {
    const TriangleMesh& mesh = placed.collider->mesh();
    const WideTree& tree = placed.collider->wide_tree();
    put(out, placed.p_world_origin);
    out.put(std::uint64_t{placed.zero_area});
    put(out, tree.outer.center);
    out.put(tree.outer.radius);
    out.put(static_cast<double>(tree.reach));
    out.put(std::uint64_t{mesh.positions.size()});
    out.put(std::uint64_t{mesh.triangles.size()});
    out.put(std::uint64_t{tree.nodes.size()});
    out.put(std::uint64_t{tree.leaves.size()});
    out.put_all(std::span(mesh.positions));
    out.put_all(std::span(mesh.triangles));
    out.align(alignof(WideNode));
    out.put_all(std::span(tree.nodes));
    out.put_all(std::span(tree.leaves));
}

Vec3 take_vector(SealedReader& in) {
    Vec3 v;
    for (Eigen::Index k = 0; k < 3; ++k) {
        v[k] = in.take<double>();
    }
    return v;
}

/// A byte of another value is no bool, and reading one from it undefined.
void check_flag(const std::byte* part, std::size_t offset) {
    if (std::to_integer<unsigned>(part[offset]) > 1) {
        throw DamagedFile("a flag in it is out of range");
    }
}

/// `flag`: where in a part its only bool is.
template <typename Part>
std::vector<Part> take_parts(SealedReader& in, std::uint64_t count, std::size_t flag,
                             const ReadBytes& was_read) {
    constexpr std::size_t kChunk = 16384;
    const std::span<const std::byte> bytes = in.take_bytes_of(count, sizeof(Part));
    std::vector<Part> parts;
    parts.reserve(count);
    collision::prefer_large_pages(parts.data(), bytes.size());
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Part)) {
        check_flag(&bytes[at], flag);
        Part part;
        std::memcpy(static_cast<void*>(&part), &bytes[at], sizeof part);
        parts.push_back(part);
        if (was_read && (parts.size() % kChunk == 0 || parts.size() == count)) {
            const std::size_t first = (parts.size() - 1) / kChunk * kChunk * sizeof(Part);
            was_read(bytes.subspan(first, at + sizeof(Part) - first));
        }
    }
    return parts;
}

PlacedMesh take_mesh(SealedReader& in, const ReadBytes& was_read) {
    PlacedMesh placed;
    placed.p_world_origin = take_vector(in);
    placed.zero_area = in.take<std::uint64_t>();
    WideTree tree;
    tree.outer.center = take_vector(in);
    tree.outer.radius = in.take<double>();
    tree.reach = static_cast<float>(in.take<double>());
    const auto positions = in.take<std::uint64_t>();
    const auto triangles = in.take<std::uint64_t>();
    const auto nodes = in.take<std::uint64_t>();
    const auto leaves = in.take<std::uint64_t>();
    TriangleMesh mesh;
    mesh.positions = in.take_all<Eigen::Vector3f>(positions);
    mesh.triangles = in.take_all<std::array<std::uint32_t, 3>>(triangles);
    in.align(alignof(WideNode));
    tree.nodes = take_parts<WideNode>(in, nodes, offsetof(WideNode, turned), was_read);
    tree.leaves = take_parts<WideLeaf>(in, leaves, offsetof(WideLeaf, exact), was_read);
    if (!placed.p_world_origin.allFinite()) {
        throw DamagedFile("a mesh in it is nowhere");
    }
    try {
        placed.collider = std::make_shared<const MeshCollider>(std::move(mesh), std::move(tree));
    } catch (const std::invalid_argument& fault) {
        throw DamagedFile(fault.what());
    }
    return placed;
}

}  // namespace

std::vector<std::byte> write_tree_file(std::span<const PlacedMesh> meshes) {
    SealedWriter out(kTreeFile);
    out.put(std::uint64_t{meshes.size()});
    for (const PlacedMesh& placed : meshes) {
        put(out, placed);
    }
    return std::move(out).seal();
}

std::vector<PlacedMesh> read_tree_file(std::span<const std::byte> bytes, const ReadBytes& was_read) {
    SealedReader in(bytes, kTreeFile);
    std::vector<PlacedMesh> meshes(in.take_count(kLeastMesh));
    for (PlacedMesh& placed : meshes) {
        placed = take_mesh(in, was_read);
    }
    in.finish();
    return meshes;
}

}  // namespace campuswalk::scene
