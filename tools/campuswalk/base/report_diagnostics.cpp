#include "tools/campuswalk/base/report_diagnostics.h"

#include <cstdio>
#include <exception>

#include "tools/campuswalk/base/exit_codes.h"

namespace campuswalk::tools {

scene::InputError error_about(const std::filesystem::path& subject, const std::string& code,
                              const std::string& message) {
    return {scene::SourceMark{subject.string(), 0, 0}, code, message};
}

void diagnose(const std::vector<scene::Diagnostic>& diagnostics) {
    for (const scene::Diagnostic& diagnostic : diagnostics) {
        diagnostic_line(scene::to_string(diagnostic));
    }
}

void diagnostic_line(const std::string& line) {
    std::fprintf(stderr, "%s\n", line.c_str());
}

int report_exceptions(const std::function<int()>& command) {
    try {
        return command();
    } catch (const scene::InputError& error) {
        diagnose(error.diagnostics());
        return kBadInput;
    } catch (const std::exception& error) {
        diagnostic_line(std::string("error: ") + error.what());
        return kRunFailed;
    }
}

}  // namespace campuswalk::tools
