#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include <Eigen/Core>

#include "engine/events/event.h"

namespace campuswalk::engine {

/// FNV-1a (64 bits) of everything that happened in a walk: equal hashes mean that all bits are equal.
class StateHash {
public:
    void add(std::uint64_t bits) {
        for (int shift = 0; shift < 64; shift += 8) {
            add_byte(static_cast<std::uint8_t>(bits >> shift));
        }
    }
    void add(double value) {
        add(std::bit_cast<std::uint64_t>(value + 0.0));  // -0 becomes 0: the same place
    }
    void add(const Eigen::Vector3d& v) {
        add(v.x());
        add(v.y());
        add(v.z());
    }
    void add(std::string_view text) {
        for (const char c : text) {
            add_byte(static_cast<std::uint8_t>(c));
        }
        add(static_cast<std::uint64_t>(text.size()));
    }
    void add(const Event& event);

    std::uint64_t value() const { return value_; }

private:
    void add_byte(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3ULL; }

    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

}  // namespace campuswalk::engine
