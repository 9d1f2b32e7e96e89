#include "tools/campuswalk/suggest/lint_text.h"

#include <algorithm>
#include <cstdio>

#include "engine/events/decimals.h"

namespace campuswalk::tools {

void print_lints(const std::vector<scene::ModelLint>& lints) {
    constexpr std::size_t kMost = 5;
    for (const scene::ModelLint& odd : lints) {
        std::printf("  %s: %s\n", odd.code.c_str(), odd.message.c_str());
        for (std::size_t p = 0; p < std::min(odd.places.size(), kMost); ++p) {
            std::printf("    '%s' at %s\n", odd.places[p].node.c_str(),
                        engine::fixed(odd.places[p].at).c_str());
        }
        if (odd.places.size() > kMost) {
            std::printf("    and %zu more: see --json\n", odd.places.size() - kMost);
        }
    }
}

}  // namespace campuswalk::tools
