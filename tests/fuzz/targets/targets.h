#pragma once

#include <cstdint>
#include <span>

namespace campuswalk::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// A reader of bytes from strangers. It may refuse them, by what it throws for bad input; whatever else it
/// does (crash, hang, break a sanitizer's rule or an assertion) is a bug.
struct Target {
    const char* name = "";
    void (*read)(Bytes bytes) = nullptr;
};

std::span<const Target> model_targets();
std::span<const Target> map_targets();
std::span<const Target> archive_targets();
std::span<const Target> text_targets();

/// Null if there is none of that name.
const Target* find_target(const char* name);

}  // namespace campuswalk::fuzz
