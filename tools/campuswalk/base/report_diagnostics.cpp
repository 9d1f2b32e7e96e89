#include "tools/campuswalk/base/report_diagnostics.h"

#include <cstdio>

namespace campuswalk::tools {

void diagnose(const std::vector<scene::Diagnostic>& diagnostics) {
    for (const scene::Diagnostic& diagnostic : diagnostics) {
        diagnostic_line(scene::to_string(diagnostic));
    }
}

void diagnostic_line(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace campuswalk::tools
