#pragma once

#include <cstdint>

namespace campuswalk::collision {

/// The instruction sets that kernels are compiled for. All give the same answers.
#ifdef __aarch64__
enum class SimdTarget : std::uint8_t { neon };
#else
enum class SimdTarget : std::uint8_t { sse42, avx2, avx512 };
#endif

/// Whether this machine has them.
bool can_run(SimdTarget simd_target);

/// What kernels run on if nobody says otherwise: NEON on AArch64; AVX2 where this machine has it, else
/// SSE4.2. AVX-512 is there for who asks for it: on the machine it was measured on (README.md), its lower
/// clock and its masks make it a tenth slower than AVX2. Throws std::runtime_error on an x86 older than 2008.
SimdTarget default_simd_target();

/// Makes another set the usual one, for the whole process and before anything is built or asked. Throws
/// std::runtime_error if this machine doesn't have it.
void use_simd_target(SimdTarget simd_target);

}  // namespace campuswalk::collision
