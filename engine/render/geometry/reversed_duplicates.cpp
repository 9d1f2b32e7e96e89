#include "engine/render/geometry/reversed_duplicates.h"

#include <array>
#include <bit>
#include <utility>

#include "scene/model/weld.h"

namespace campuswalk::engine::render {
namespace {

using Position = std::array<std::uint32_t, 3>;  // bits

std::uint64_t mixed(std::uint64_t h) {
    h *= 0xFF51AFD7ED558CCDU;
    return h ^ (h >> 32U);
}

enum class Match { none, same_winding, opposite_winding };

/// A hash table of triangles by their vertex positions, independent of rotation and winding.
class DuplicateFinder {
public:
    DuplicateFinder(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                    std::span<const std::uint32_t> groups)
        : vertices_(vertices), indices_(indices), groups_(groups), reversed_(indices.size() / 3, false) {
        slots_.resize(std::bit_ceil(2 * reversed_.size() + 16));
        hashes_.reserve(vertices.size());
        for (const Vertex& vertex : vertices) {
            const Position p = bits(vertex);
            hashes_.push_back(mixed(mixed(mixed(p[0]) ^ p[1]) ^ p[2]));
        }
    }

    std::vector<bool> find() {
        for (std::size_t triangle = 0; triangle < reversed_.size(); ++triangle) {
            insert(static_cast<std::uint32_t>(triangle));
        }
        // A repeat of the same winding shares the result of the first occurrence.
        for (const auto& [later, first] : repeats_) {
            reversed_[later] = reversed_[first];
        }
        return std::move(reversed_);
    }

private:
    struct Slot {
        std::uint32_t tag = 0;  // upper bits of the hash
        std::uint32_t triangle = kEmpty;
    };
    static constexpr std::uint32_t kEmpty = 0xFFFFFFFF;

    static Position bits(const Vertex& vertex) {
        return {scene::bits_of(vertex.position[0]), scene::bits_of(vertex.position[1]),
                scene::bits_of(vertex.position[2])};
    }

    void insert(std::uint32_t triangle) {
        const std::size_t first = std::size_t{3} * triangle;
        // A sum, so that the order of the vertices is irrelevant.
        const std::uint64_t hash =
            mixed(hashes_[indices_[first]] + hashes_[indices_[first + 1]] + hashes_[indices_[first + 2]]);
        const auto tag = static_cast<std::uint32_t>(hash >> 32U);
        std::size_t at = static_cast<std::size_t>(hash) & (slots_.size() - 1);
        for (; slots_[at].triangle != kEmpty; at = (at + 1) & (slots_.size() - 1)) {
            if (slots_[at].tag != tag) {
                continue;
            }
            const std::uint32_t existing = slots_[at].triangle;
            const Match match = compare(existing, triangle);
            if (match == Match::opposite_winding) {
                reversed_[existing] = reversed_[triangle] = true;
            } else if (match == Match::same_winding) {
                repeats_.emplace_back(triangle, existing);
            }
            if (match != Match::none) {
                return;
            }
        }
        slots_[at] = {tag, triangle};
    }

    std::array<Position, 3> positions(std::uint32_t triangle) const {
        const std::size_t first = std::size_t{3} * triangle;
        return {bits(vertices_[indices_[first]]), bits(vertices_[indices_[first + 1]]),
                bits(vertices_[indices_[first + 2]])};
    }

    Match compare(std::uint32_t triangle_a, std::uint32_t triangle_b) const {
        if (groups_[triangle_a] != groups_[triangle_b]) {
            return Match::none;
        }
        const std::array<Position, 3> a = positions(triangle_a);
        const std::array<Position, 3> b = positions(triangle_b);
        for (std::size_t start = 0; start < 3; ++start) {
            const Position& second = b[(start + 1) % 3];
            const Position& third = b[(start + 2) % 3];
            if (a[0] == b[start] && a[1] == second && a[2] == third) {
                return Match::same_winding;
            }
            if (a[0] == b[start] && a[1] == third && a[2] == second) {
                return Match::opposite_winding;
            }
        }
        return Match::none;
    }

    std::span<const Vertex> vertices_;
    std::span<const std::uint32_t> indices_;
    std::span<const std::uint32_t> groups_;
    std::vector<bool> reversed_;
    std::vector<std::uint64_t> hashes_;  // of the vertices' positions
    std::vector<Slot> slots_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> repeats_;
};

}  // namespace

std::vector<bool> find_reversed_duplicates(std::span<const Vertex> vertices,
                                           std::span<const std::uint32_t> indices,
                                           std::span<const std::uint32_t> groups) {
    return DuplicateFinder(vertices, indices, groups).find();
}

}  // namespace campuswalk::engine::render
