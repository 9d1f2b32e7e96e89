#include "tools/campuswalk/complaints.h"

#include <cstdio>

namespace campuswalk::tools {

void complain(const std::vector<scene::Diagnostic>& diagnostics) {
    for (const scene::Diagnostic& diagnostic : diagnostics) {
        complain_line(scene::to_string(diagnostic));
    }
}

void complain_line(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace campuswalk::tools
