#pragma once

#include <cstdint>

namespace campuswalk::collision {

/// The instruction sets that kernels are compiled for. All give the same answers.
enum class Instructions : std::uint8_t { sse42, avx2, avx512 };

/// Whether this machine has them.
bool can_run(Instructions instructions);

/// The most capable that this machine has. Throws std::runtime_error on an x86 older than 2008.
Instructions fastest_instructions();

}  // namespace campuswalk::collision
