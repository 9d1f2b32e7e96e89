#include "scene/import/gltf/draco_header.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/import/gltf/packed_meshes.h"

namespace campuswalk::scene::gltf {
namespace {

using Packed = std::vector<std::uint8_t>;

constexpr std::uint8_t kSequential = 0;
constexpr std::uint8_t kEdgebreaker = 1;

Packed start_of(std::uint8_t minor_version, std::uint8_t method, bool has_metadata = false) {
    return {'D',
            'R',
            'A',
            'C',
            'O',
            2,
            minor_version,
            1,
            method,
            0,
            static_cast<std::uint8_t>(has_metadata ? 0x80 : 0)};
}

void put_varint(Packed& packed, std::uint32_t number) {
    for (; number > 0x7F; number >>= 7U) {
        packed.push_back(static_cast<std::uint8_t>(0x80U | (number & 0x7FU)));
    }
    packed.push_back(static_cast<std::uint8_t>(number));
}

/// With 100 bytes of data.
Packed edgebreaker(std::uint32_t vertices, std::uint32_t triangles, std::uint8_t attributes = 0,
                   const Packed& metadata = {}) {
    Packed packed = start_of(2, kEdgebreaker, !metadata.empty());
    packed.insert(packed.end(), metadata.begin(), metadata.end());
    packed.push_back(0);  // the kind of traversal
    put_varint(packed, vertices);
    put_varint(packed, triangles);
    packed.push_back(attributes);
    packed.resize(packed.size() + 100);
    return packed;
}

/// As before version 2.2: with numbers of four bytes.
Packed old_sequential(std::uint32_t triangles, std::uint32_t vertices) {
    Packed packed = start_of(1, kSequential);
    for (const std::uint32_t number : {triangles, vertices}) {
        for (const unsigned shift : {0U, 8U, 16U, 24U}) {
            packed.push_back(static_cast<std::uint8_t>(number >> shift));
        }
    }
    packed.resize(packed.size() + 100);
    return packed;
}

TEST(DracoHeader, AcceptsWhatEncodersWrite) {
    for (const std::size_t side : {2U, 10U, 300U}) {
        EXPECT_EQ(why_draco_too_large(test::draco_of(test::grid_mesh(side))), "") << side;
    }
}

TEST(DracoHeader, ComparesCountsWithTheBytes) {
    EXPECT_EQ(why_draco_too_large(edgebreaker(100'000, 110'000)), "");
    EXPECT_EQ(why_draco_too_large(edgebreaker(100'000, 110'001)),
              "announces 110001 triangles, more than 100 bytes can hold");
    EXPECT_EQ(why_draco_too_large(edgebreaker(110'001, 100'000)),
              "announces 110001 vertices, more than 100 bytes can hold");
    EXPECT_EQ(why_draco_too_large(old_sequential(110'000, 110'000)), "");
    EXPECT_EQ(why_draco_too_large(old_sequential(1, 4'000'000'000)),
              "announces 4000000000 vertices, more than 100 bytes can hold");
}

TEST(DracoHeader, RefusesMoreTrianglesThanAModelMayHave) {
    Packed packed = edgebreaker(50'000'001, 50'000'001);
    packed.resize(100'000);
    EXPECT_EQ(why_draco_too_large(packed), "announces 50000001 triangles; a model may have 50000000");
}

TEST(DracoHeader, RefusesMoreAttributesThanBytesDescribe) {
    EXPECT_EQ(why_draco_too_large(edgebreaker(3, 1, 10)), "");
    EXPECT_EQ(why_draco_too_large(edgebreaker(3, 1, 11)),
              "announces 11 attributes, more than 100 bytes can hold");
}

TEST(DracoHeader, SkipsMetadata) {
    const Packed value = {1, 'k', 2, 'a', 'b'};
    Packed metadata = {1, 7, 1};  // of attribute 7: one value
    metadata.insert(metadata.end(), value.begin(), value.end());
    metadata.insert(metadata.end(), {0, 0, 2});  // of the mesh: no value, two trees
    metadata.insert(metadata.end(), {1, 'x', 0, 1, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(why_draco_too_large(edgebreaker(3, 1, 0, metadata)), "");
    EXPECT_EQ(why_draco_too_large(edgebreaker(3, 110'001, 0, metadata)),
              "announces 110001 triangles, more than 100 bytes can hold");
    Packed trees = {0, 0};  // of the mesh: as many trees as four bytes can say
    put_varint(trees, 0xFFFF'FFFF);
    EXPECT_EQ(why_draco_too_large(edgebreaker(3, 1, 0, trees)), "ends before its data begins");
}

TEST(DracoHeader, RefusesBytesThatEndInIt) {
    const Packed whole = edgebreaker(100'000, 100'000);
    for (std::size_t size = 0; size < whole.size() - 100; ++size) {
        EXPECT_EQ(why_draco_too_large(Bytes(whole).first(size)), "ends before its data begins") << size;
    }
}

TEST(DracoHeader, LeavesPointCloudsToTheDecoder) {
    Packed cloud = edgebreaker(100, 4'000'000'000);
    cloud[7] = 0;
    EXPECT_EQ(why_draco_too_large(cloud), "");
}

}  // namespace
}  // namespace campuswalk::scene::gltf
