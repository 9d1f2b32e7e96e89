#include "tests/fuzz/targets/targets.h"

#include <array>
#include <string_view>

namespace campuswalk::fuzz {

const Target* find_target(const char* name) {
    for (const std::span<const Target> targets :
         {model_targets(), map_targets(), archive_targets(), text_targets()}) {
        for (const Target& target : targets) {
            if (std::string_view(target.name) == name) {
                return &target;
            }
        }
    }
    return nullptr;
}

}  // namespace campuswalk::fuzz
