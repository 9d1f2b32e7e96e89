#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace campuswalk::scene {

/// The bits of a float as a key; -0 and +0 have the same.
inline std::uint32_t bits_of(float value) {
    return std::bit_cast<std::uint32_t>(value + 0.0F);
}

inline std::array<std::uint32_t, 3> bits_of(const Eigen::Vector3f& v) {
    return {bits_of(v.x()), bits_of(v.y()), bits_of(v.z())};
}

/// A hash table that numbers distinct keys 0, 1, 2, … in order of insertion; welds vertices that are equal to
/// the bit. Unlike welding with a tolerance it depends neither on order nor on scale.
template <std::size_t Words>
class WeldTable {
public:
    using Key = std::array<std::uint32_t, Words>;

    explicit WeldTable(std::size_t expected) { slots_.assign(std::bit_ceil(expected * 2 + 16), kEmpty); }

    /// Inserts the key if it is new: the result is then size() before the call.
    std::uint32_t number_of(const Key& key) {
        if ((keys_.size() + 1) * 2 > slots_.size()) {
            grow();
        }
        std::size_t slot = hash(key) & (slots_.size() - 1);
        while (slots_[slot] != kEmpty) {
            if (keys_[slots_[slot]] == key) {
                return slots_[slot];
            }
            slot = (slot + 1) & (slots_.size() - 1);
        }
        slots_[slot] = static_cast<std::uint32_t>(keys_.size());
        keys_.push_back(key);
        return slots_[slot];
    }

    std::size_t size() const { return keys_.size(); }

private:
    static constexpr std::uint32_t kEmpty = 0xFFFFFFFF;

    static std::size_t hash(const Key& key) {
        std::uint64_t h = 0x9E3779B97F4A7C15U;
        for (const std::uint32_t word : key) {
            h = (h ^ word) * 0xFF51AFD7ED558CCDU;
            h ^= h >> 32U;
        }
        return static_cast<std::size_t>(h);
    }

    void grow() {
        slots_.assign(slots_.size() * 2, kEmpty);
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            std::size_t slot = hash(keys_[i]) & (slots_.size() - 1);
            while (slots_[slot] != kEmpty) {
                slot = (slot + 1) & (slots_.size() - 1);
            }
            slots_[slot] = static_cast<std::uint32_t>(i);
        }
    }

    std::vector<std::uint32_t> slots_;
    std::vector<Key> keys_;
};

}  // namespace campuswalk::scene
