#pragma once

namespace campuswalk::tools {

/// The environment may name the instruction set that collision kernels run on, as
/// CAMPUSWALK_INSTRUCTIONS=sse42|avx2|avx512: what a walk does is the same on each. Throws scene::InputError
/// when there is no such set, or none here.
void use_simd_target_from_environment();

}  // namespace campuswalk::tools
