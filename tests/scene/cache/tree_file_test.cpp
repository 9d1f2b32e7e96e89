#include "scene/cache/tree_file.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "collision/mesh/mesh_query.h"
#include "scene/base/checksum.h"
#include "tests/support/dice.h"
#include "tests/support/mesh_pieces.h"

namespace campuswalk::scene {
namespace {

using collision::MeshCollider;
using collision::TriangleMesh;
using collision::Vec3;

TriangleMesh scattered(std::uint32_t triangles, std::uint32_t seed) {
    support::Dice dice(seed);
    TriangleMesh mesh;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        const Vec3 place = dice.in_cube(10.0);
        for (int c = 0; c < 3; ++c) {
            mesh.positions.push_back((place + dice.in_cube(1.0)).cast<float>());
        }
        mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    return mesh;
}

PlacedMesh placed(std::uint32_t triangles, std::uint32_t seed) {
    PlacedMesh made;
    made.collider = std::make_shared<const MeshCollider>(scattered(triangles, seed));
    made.p_world_origin = {1.0 / 3.0, -2, seed * 1e4};
    made.zero_area = seed;
    made.object = "object/" + std::to_string(seed);
    return made;
}

std::vector<collision::MeshHit> hits(const MeshCollider& mesh) {
    support::Dice dice(5);
    std::vector<collision::MeshHit> found;
    for (int i = 0; i < 200; ++i) {
        const Vec3 from = dice.in_cube(12.0);
        const Vec3 to = dice.in_cube(12.0);
        if (const auto hit = first_on_ray(mesh, {from, to})) {
            found.push_back(*hit);
        }
    }
    return found;
}

/// Queries what could be read, for sanitizers. False if it was rejected.
bool can_be_read(std::span<const std::byte> bytes) {
    try {
        for (const PlacedMesh& mesh : read_tree_file(bytes)) {
            hits(*mesh.collider);
            std::vector<std::uint32_t> near;
            triangles_near(*mesh.collider, {{0, 0, 0}, {0, 1, 0}}, 3.0, near);
            for (const std::uint32_t t : near) {
                EXPECT_LT(t, mesh.collider->mesh().triangles.size());
            }
        }
        return true;
    } catch (const DamagedFile&) {
        return false;
    }
}

std::vector<std::byte> write_tree_file(std::span<const PlacedMesh> meshes) {
    ArchiveWriter archive = archive_trees(meshes);
    return concatenated(archive.finish());
}

/// Corrects the size and the checksum, as a forger would.
void fix_header(std::vector<std::byte>& bytes) {
    const std::uint64_t payload = bytes.size() - kArchiveHeaderBytes;
    const std::uint64_t checksum =
        checksum_of(std::span<const std::byte>(bytes).subspan(kArchiveHeaderBytes));
    std::memcpy(bytes.data() + 16, &payload, sizeof payload);
    std::memcpy(bytes.data() + 24, &checksum, sizeof checksum);
}

TEST(TreeFile, RoundTripsMeshesThatAnswerQueriesAlike) {
    const std::vector<PlacedMesh> made = {placed(1, 1), placed(900, 2)};
    const std::vector<PlacedMesh> read = read_tree_file(write_tree_file(made));
    ASSERT_EQ(read.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(read[i].p_world_origin, made[i].p_world_origin);
        EXPECT_EQ(read[i].zero_area, made[i].zero_area);
        EXPECT_EQ(read[i].object, made[i].object);
        EXPECT_EQ(read[i].collider->mesh().positions, made[i].collider->mesh().positions);
        EXPECT_EQ(read[i].collider->mesh().triangles, made[i].collider->mesh().triangles);
        EXPECT_EQ(hits(*read[i].collider), hits(*made[i].collider));
    }
    EXPECT_GT(hits(*made[1].collider).size(), 20U);
}

/// A copy that starts `off` bytes after an aligned address.
std::pair<std::shared_ptr<const void>, std::span<const std::byte>> owned(const std::vector<std::byte>& bytes,
                                                                         std::size_t off) {
    struct alignas(64) Line {
        std::byte bytes[64];
    };
    auto lines = std::make_shared<std::vector<Line>>(bytes.size() / sizeof(Line) + 2);
    std::byte* start = lines->data()->bytes + off;
    std::copy(bytes.begin(), bytes.end(), start);
    return {lines, {start, bytes.size()}};
}

TEST(TreeFile, RefersToOwnedBytesWithoutCopying) {
    std::vector<PlacedMesh> made = {placed(900, 2)};
    TriangleMesh box;
    support::add_box(box, {0, 0, 0}, {1, 1, 1});
    made.push_back({"box", std::make_shared<const MeshCollider>(box), {}, 0});
    const std::vector<std::byte> bytes = write_tree_file(made);
    for (const std::size_t off : {0U, 8U}) {
        std::vector<PlacedMesh> read;
        const std::byte* start = nullptr;
        {
            const auto [owner, where] = owned(bytes, off);
            start = where.data();
            read = read_tree_file(where, owner);
        }
        ASSERT_EQ(read.size(), 2U);
        const auto& nodes = read[0].collider->bvh8().nodes;
        const auto* first = reinterpret_cast<const std::byte*>(nodes.data());
        EXPECT_EQ(nodes.is_external(), off == 0) << "unaligned arrays are copied";
        EXPECT_EQ(first > start && first < start + bytes.size(), off == 0);
        EXPECT_TRUE(read[0].collider->mesh().positions.is_external());
        EXPECT_EQ(hits(*read[0].collider), hits(*made[0].collider));
        EXPECT_TRUE(read[0].collider->closed_parts().empty());
        EXPECT_EQ(read[1].collider->closed_parts().members(), made[1].collider->closed_parts().members());
        EXPECT_EQ(read[1].collider->closed_parts().bounds().max, collision::Vec3(1, 1, 1));
    }
}

TEST(TreeFile, RejectsEveryTruncationAndFlippedBit) {
    const std::vector<PlacedMesh> made = {placed(20, 3)};
    std::vector<std::byte> bytes = write_tree_file(made);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        EXPECT_FALSE(can_be_read({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}));
    }
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        bytes[at] ^= std::byte{1} << at % 8;
        EXPECT_FALSE(can_be_read(bytes)) << at;
        bytes[at] ^= std::byte{1} << at % 8;
    }
    EXPECT_TRUE(can_be_read(bytes));
}

/// With a valid checksum: what is accepted is safe to query.
TEST(TreeFile, IsRejectedOrSafeToQueryWhenForged) {
    const std::vector<PlacedMesh> made = {placed(150, 4)};
    const std::vector<std::byte> whole = write_tree_file(made);
    std::size_t refused = 0;
    for (std::size_t at = kArchiveHeaderBytes; at < whole.size(); at += 3) {
        for (const int value : {0x01, 0x10, 0x80, 0xFF}) {
            std::vector<std::byte> bytes = whole;
            bytes[at] ^= static_cast<std::byte>(value);
            fix_header(bytes);
            refused += can_be_read(bytes) ? 0U : 1U;
        }
    }
    EXPECT_GT(refused, whole.size() / 10);
    for (std::size_t length = kArchiveHeaderBytes; length < whole.size(); length += 5) {
        std::vector<std::byte> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
        fix_header(part);
        EXPECT_FALSE(can_be_read(part)) << length;
    }
}

TEST(TreeFile, RejectsAnInvalidBool) {
    const std::vector<PlacedMesh> made = {placed(1, 4)};
    std::vector<std::byte> bytes = write_tree_file(made);
    ASSERT_TRUE(made[0].collider->closed_parts().empty()) << "otherwise the file would end with these";
    bytes[bytes.size() - sizeof(collision::Bvh8Leaf) + offsetof(collision::Bvh8Leaf, exact)] = std::byte{2};
    fix_header(bytes);
    EXPECT_FALSE(can_be_read(bytes));
}

}  // namespace
}  // namespace campuswalk::scene
