#include "tools/campuswalk/base/report_diagnostics.h"

#include <exception>

#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/standard_streams.h"

namespace campuswalk::tools {

scene::InputError error_about(const std::filesystem::path& subject, scene::DiagnosticCode code,
                              const std::string& message) {
    return {scene::SourceMark{subject.string(), 0, 0}, code, message};
}

void diagnose(const std::vector<scene::Diagnostic>& diagnostics) {
    for (const scene::Diagnostic& diagnostic : diagnostics) {
        print_error_line(scene::to_string(diagnostic));
    }
}

int report_exceptions(const std::function<int()>& command) {
    try {
        return command();
    } catch (const scene::InputError& error) {
        diagnose(error.diagnostics());
        return kBadInput;
    } catch (const NoReader&) {
        return kRunFailed;  // not a success: what was to be said, such as that a walk fails, wasn't read
    } catch (const std::exception& error) {
        print_error_line(std::string("error: ") + error.what());
        return kRunFailed;
    }
}

}  // namespace campuswalk::tools
