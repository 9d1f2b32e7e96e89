#include "tools/campuswalk/wanted_instructions.h"

#include <cstdlib>
#include <map>
#include <string>

#include "collision/base/simd_target.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

void use_simd_target_from_environment() {
    using collision::SimdTarget;
    const char* wanted = std::getenv("CAMPUSWALK_INSTRUCTIONS");
    if (wanted == nullptr || *wanted == '\0') {
        return;
    }
    const std::map<std::string, SimdTarget> known = {
        {"sse42", SimdTarget::sse42}, {"avx2", SimdTarget::avx2}, {"avx512", SimdTarget::avx512}};
    const auto found = known.find(wanted);
    const bool usable = found != known.end() && can_run(found->second);
    if (!usable) {
        const std::string why =
            found == known.end() ? "' is none of sse42, avx2, avx512" : "': this processor can't";
        throw scene::InputError({"CAMPUSWALK_INSTRUCTIONS", 0, 0}, "bad-value",
                                "'" + std::string(wanted) + why);
    }
    collision::use_simd_target(found->second);
}

}  // namespace campuswalk::tools
