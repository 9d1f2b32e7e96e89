#include "tests/packed_walks/packed_walk.h"

#include <memory>
#include <utility>

#include "tests/packed_walks/aggregate_archive.h"

namespace campuswalk::packed {

namespace {

constexpr scene::FileKind kPackedWalk = {{'c', 'w', ' ', 'w', 'a', 'l', 'k', 's'}, 1};

}  // namespace

std::vector<std::byte> pack_walk(const scene::Campus& campus, const engine::Walk& walk) {
    std::vector<collision::Object> colliders;
    for (std::uint32_t i = 0; i < campus.world.size(); ++i) {
        colliders.push_back(campus.world.object(collision::ObjectId{i}));
    }
    ArchiveWriter out(kPackedWalk);
    put(out, campus.description);
    put(out, campus.objects);
    put(out, colliders);
    put(out, campus.origin);
    put(out, walk);
    return scene::concatenated(out.finish());
}

PackedWalk unpack_walk(std::span<const std::byte> bytes) {
    ArchiveReader in(bytes, kPackedWalk);
    PackedWalk packed{{{}, {}, {}, collision::World(std::make_unique<collision::LinearBroadPhase>())}, {}};
    std::vector<collision::Object> colliders;
    take(in, packed.campus.description);
    take(in, packed.campus.objects);
    take(in, colliders);
    take(in, packed.campus.origin);
    take(in, packed.walk);
    in.finish();
    for (collision::Object& collider : colliders) {
        packed.campus.world.add(std::move(collider));
    }
    return packed;
}

}  // namespace campuswalk::packed
