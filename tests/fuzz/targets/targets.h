#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/base/binary_archive.h"

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

/// The bytes behind a header of this kind, with the length and the checksum that they need.
std::vector<std::byte> forged(const scene::FileKind& kind, Bytes payload);

/// Null if there is none of that name.
const Target* find_target(const char* name);

}  // namespace campuswalk::fuzz
