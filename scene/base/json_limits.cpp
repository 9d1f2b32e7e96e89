#include "scene/base/json_limits.h"

#include <array>
#include <cstddef>

namespace campuswalk::scene {

std::string why_too_complex(std::string_view json) {
    std::array<int, kDeepestJson + 1> names{};  // by depth, of the object or list that is open there
    std::size_t depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (c == '"') {
            in_string = !in_string;
        } else if (in_string) {
            i += c == '\\' ? 1 : 0;
        } else if (c == '[' || c == '{') {
            if (++depth > kDeepestJson) {
                return "it is nested deeply";
            }
            names[depth] = 0;
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        } else if (c == ':' && ++names[depth] > kMostJsonMembers) {
            return "an object in it has more than " + std::to_string(kMostJsonMembers) + " members";
        }
    }
    return "";
}

}  // namespace campuswalk::scene
