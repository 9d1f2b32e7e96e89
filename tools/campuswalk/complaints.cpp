#include "tools/campuswalk/complaints.h"

#include <cstdio>

namespace campuswalk::tools {

void complain(const std::vector<scene::Diagnostic>& diagnostics) {
    for (const scene::Diagnostic& diagnostic : diagnostics) {
        std::fprintf(stderr, "%s\n", scene::to_string(diagnostic).c_str());
    }
}

}  // namespace campuswalk::tools
