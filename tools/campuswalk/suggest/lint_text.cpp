#include "tools/campuswalk/suggest/lint_text.h"

#include <algorithm>

#include "engine/events/decimals.h"
#include "tools/campuswalk/base/print.h"

namespace campuswalk::tools {

void print_lints(const std::vector<scene::ModelLint>& lints) {
    constexpr std::size_t kMax = 5;
    for (const scene::ModelLint& lint : lints) {
        print_line("  %s: %s", std::string(lint.code.text()).c_str(), lint.message.c_str());
        for (std::size_t p = 0; p < std::min(lint.places.size(), kMax); ++p) {
            print_line("    '%s' at %s", lint.places[p].node.c_str(),
                       engine::fixed(lint.places[p].at).c_str());
        }
        if (lint.places.size() > kMax) {
            print_line("    and %zu more: see --json", lint.places.size() - kMax);
        }
    }
}

}  // namespace campuswalk::tools
