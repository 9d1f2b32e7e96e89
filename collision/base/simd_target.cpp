#include "collision/base/simd_target.h"

#include <stdexcept>

namespace campuswalk::collision {

#ifdef __aarch64__

// Every AArch64 processor has NEON.

bool can_run(SimdTarget simd_target) {
    return simd_target == SimdTarget::neon;
}

namespace {

SimdTarget fastest() {
    return SimdTarget::neon;
}

}  // namespace

#else

bool can_run(SimdTarget simd_target) {
    switch (simd_target) {
        case SimdTarget::sse42:
            return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
                   __builtin_cpu_supports("aes");
        case SimdTarget::avx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                   __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
        case SimdTarget::avx512:
            return can_run(SimdTarget::avx2) && __builtin_cpu_supports("avx512f") &&
                   __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    }
    return false;
}

namespace {

SimdTarget fastest() {
    for (const SimdTarget best : {SimdTarget::avx2, SimdTarget::sse42}) {
        if (can_run(best)) {
            return best;
        }
    }
    throw std::runtime_error("collision queries need a processor with SSE4.2");
}

}  // namespace

#endif

namespace {

SimdTarget& default_target() {
    static SimdTarget simd_target = fastest();
    return simd_target;
}

}  // namespace

SimdTarget default_simd_target() {
    return default_target();
}

void use_simd_target(SimdTarget simd_target) {
    if (!can_run(simd_target)) {
        throw std::runtime_error("this processor doesn't support the requested instruction set");
    }
    default_target() = simd_target;
}

}  // namespace campuswalk::collision
