#include "engine/render/geometry/reversed_twins.h"

#include <array>
#include <bit>
#include <utility>

#include "scene/model/weld.h"

namespace campuswalk::engine::render {
namespace {

using Position = std::array<std::uint32_t, 3>;  // bits

std::uint64_t scattered(std::uint64_t h) {
    h *= 0xFF51AFD7ED558CCDU;
    return h ^ (h >> 32U);
}

enum class Match { none, same_way, other_way };

/// A hash table of triangles by their corners, whatever corner they begin with and whichever way they run.
class TwinFinder {
public:
    TwinFinder(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
               std::span<const std::uint32_t> families)
        : vertices_(vertices), indices_(indices), families_(families), twin_(indices.size() / 3, false) {
        slots_.resize(std::bit_ceil(2 * twin_.size() + 16));
        hashes_.reserve(vertices.size());
        for (const Vertex& vertex : vertices) {
            const Position p = bits(vertex);
            hashes_.push_back(scattered(scattered(scattered(p[0]) ^ p[1]) ^ p[2]));
        }
    }

    std::vector<bool> find() {
        for (std::size_t triangle = 0; triangle < twin_.size(); ++triangle) {
            enter(static_cast<std::uint32_t>(triangle));
        }
        // What lies twice the same way has the twin of the first of them.
        for (const auto& [later, first] : repeats_) {
            twin_[later] = twin_[first];
        }
        return std::move(twin_);
    }

private:
    struct Slot {
        std::uint32_t tag = 0;  // of the hash, what the slot's number doesn't say
        std::uint32_t triangle = kEmpty;
    };
    static constexpr std::uint32_t kEmpty = 0xFFFFFFFF;

    static Position bits(const Vertex& vertex) {
        return {scene::bits_of(vertex.position[0]), scene::bits_of(vertex.position[1]),
                scene::bits_of(vertex.position[2])};
    }

    void enter(std::uint32_t triangle) {
        const std::size_t first = std::size_t{3} * triangle;
        // A sum, because it must not depend on the corners' order.
        const std::uint64_t hash =
            scattered(hashes_[indices_[first]] + hashes_[indices_[first + 1]] + hashes_[indices_[first + 2]]);
        const auto tag = static_cast<std::uint32_t>(hash >> 32U);
        std::size_t at = static_cast<std::size_t>(hash) & (slots_.size() - 1);
        for (; slots_[at].triangle != kEmpty; at = (at + 1) & (slots_.size() - 1)) {
            if (slots_[at].tag != tag) {
                continue;
            }
            const std::uint32_t known = slots_[at].triangle;
            const Match match = compare(known, triangle);
            if (match == Match::other_way) {
                twin_[known] = twin_[triangle] = true;
            } else if (match == Match::same_way) {
                repeats_.emplace_back(triangle, known);
            }
            if (match != Match::none) {
                return;
            }
        }
        slots_[at] = {tag, triangle};
    }

    std::array<Position, 3> corners(std::uint32_t triangle) const {
        const std::size_t first = std::size_t{3} * triangle;
        return {bits(vertices_[indices_[first]]), bits(vertices_[indices_[first + 1]]),
                bits(vertices_[indices_[first + 2]])};
    }

    Match compare(std::uint32_t triangle_a, std::uint32_t triangle_b) const {
        if (families_[triangle_a] != families_[triangle_b]) {
            return Match::none;
        }
        const std::array<Position, 3> a = corners(triangle_a);
        const std::array<Position, 3> b = corners(triangle_b);
        for (std::size_t turn = 0; turn < 3; ++turn) {
            const Position& second = b[(turn + 1) % 3];
            const Position& third = b[(turn + 2) % 3];
            if (a[0] == b[turn] && a[1] == second && a[2] == third) {
                return Match::same_way;
            }
            if (a[0] == b[turn] && a[1] == third && a[2] == second) {
                return Match::other_way;
            }
        }
        return Match::none;
    }

    std::span<const Vertex> vertices_;
    std::span<const std::uint32_t> indices_;
    std::span<const std::uint32_t> families_;
    std::vector<bool> twin_;
    std::vector<std::uint64_t> hashes_;  // of the vertices' positions
    std::vector<Slot> slots_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> repeats_;
};

}  // namespace

std::vector<bool> reversed_twins(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                                 std::span<const std::uint32_t> families) {
    return TwinFinder(vertices, indices, families).find();
}

}  // namespace campuswalk::engine::render
