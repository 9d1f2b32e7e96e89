#include "tools/campuswalk/suggest/lint_text.h"

#include <algorithm>
#include <cstdio>

#include "engine/events/decimals.h"

namespace campuswalk::tools {

void print_lints(const std::vector<scene::ModelLint>& lints) {
    constexpr std::size_t kMax = 5;
    for (const scene::ModelLint& lint : lints) {
        std::printf("  %s: %s\n", lint.code.c_str(), lint.message.c_str());
        for (std::size_t p = 0; p < std::min(lint.places.size(), kMax); ++p) {
            std::printf("    '%s' at %s\n", lint.places[p].node.c_str(),
                        engine::fixed(lint.places[p].at).c_str());
        }
        if (lint.places.size() > kMax) {
            std::printf("    and %zu more: see --json\n", lint.places.size() - kMax);
        }
    }
}

}  // namespace campuswalk::tools
