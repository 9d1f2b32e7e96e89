#include "tools/campuswalk/wanted_instructions.h"

#include <cstdlib>
#include <map>
#include <string>

#include "collision/base/simd_target.h"
#include "scene/base/diagnostic.h"

namespace campuswalk::tools {

void use_wanted_instructions() {
    using collision::Instructions;
    const char* wanted = std::getenv("CAMPUSWALK_INSTRUCTIONS");
    if (wanted == nullptr || *wanted == '\0') {
        return;
    }
    const std::map<std::string, Instructions> known = {
        {"sse42", Instructions::sse42}, {"avx2", Instructions::avx2}, {"avx512", Instructions::avx512}};
    const auto found = known.find(wanted);
    const bool usable = found != known.end() && can_run(found->second);
    if (!usable) {
        const std::string why =
            found == known.end() ? "' is none of sse42, avx2, avx512" : "': this processor can't";
        throw scene::InputError({"CAMPUSWALK_INSTRUCTIONS", 0, 0}, "bad-value",
                                "'" + std::string(wanted) + why);
    }
    collision::use_instructions(found->second);
}

}  // namespace campuswalk::tools
