#pragma once

#include <cstdint>

namespace campuswalk::collision {

/// The instruction sets that kernels are compiled for. All produce the same results.
#ifdef __aarch64__
enum class SimdTarget : std::uint8_t { neon };
#else
enum class SimdTarget : std::uint8_t { sse42, avx2, avx512 };
#endif

/// Whether this machine supports it.
bool can_run(SimdTarget simd_target);

/// The default of all queries: NEON on AArch64; on x86 AVX2 if this machine has it, else SSE4.2. AVX-512 must
/// be requested: where it was measured (collision/README.md), it is as fast as AVX2 or 5 % slower. Throws
/// std::runtime_error on an x86 older than 2008.
SimdTarget default_simd_target();

/// Changes the default, for the whole process; call it before any tree is built or queried. Throws
/// std::runtime_error if this machine doesn't support it.
void use_simd_target(SimdTarget simd_target);

}  // namespace campuswalk::collision
