#include "config/loader/complaint_limit.h"

#include <utility>

namespace campuswalk::config {

namespace {

constexpr std::size_t kMaxDiagnostics = 200;

}  // namespace

bool is_full(const scene::DiagnosticList& diagnostics) {
    return diagnostics.all().size() >= kMaxDiagnostics;
}

void add_diagnostic(scene::DiagnosticList& diagnostics, const scene::SourceMark& mark, std::string code,
                    std::string message) {
    if (is_full(diagnostics)) {
        return;
    }
    diagnostics.error(mark, std::move(code), std::move(message));
    if (is_full(diagnostics)) {
        diagnostics.error(
            {mark.file, 0, 0}, "too-many",
            "there are more mistakes than " + std::to_string(kMaxDiagnostics) + "; these are the first");
    }
}

}  // namespace campuswalk::config
