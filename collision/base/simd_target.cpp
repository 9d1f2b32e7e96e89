#include "collision/base/simd_target.h"

#include <stdexcept>

namespace campuswalk::collision {

bool can_run(Instructions instructions) {
    switch (instructions) {
        case Instructions::sse42:
            return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
                   __builtin_cpu_supports("aes");
        case Instructions::avx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                   __builtin_cpu_supports("bmi") && __builtin_cpu_supports("bmi2");
        case Instructions::avx512:
            return can_run(Instructions::avx2) && __builtin_cpu_supports("avx512f") &&
                   __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    }
    return false;
}

namespace {

Instructions fastest() {
    for (const Instructions best : {Instructions::avx2, Instructions::sse42}) {
        if (can_run(best)) {
            return best;
        }
    }
    throw std::runtime_error("collision queries need a processor with SSE4.2");
}

Instructions& usual() {
    static Instructions instructions = fastest();
    return instructions;
}

}  // namespace

Instructions usual_instructions() {
    return usual();
}

void use_instructions(Instructions instructions) {
    if (!can_run(instructions)) {
        throw std::runtime_error("this processor hasn't got these instructions");
    }
    usual() = instructions;
}

}  // namespace campuswalk::collision
