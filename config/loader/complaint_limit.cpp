#include "config/loader/complaint_limit.h"

#include <utility>

namespace campuswalk::config {

namespace {

constexpr std::size_t kMostComplaints = 200;

}  // namespace

bool is_full(const scene::DiagnosticList& diagnostics) {
    return diagnostics.all().size() >= kMostComplaints;
}

void add_complaint(scene::DiagnosticList& diagnostics, const scene::SourceMark& mark, std::string code,
                   std::string message) {
    if (is_full(diagnostics)) {
        return;
    }
    diagnostics.error(mark, std::move(code), std::move(message));
    if (is_full(diagnostics)) {
        diagnostics.error(
            {mark.file, 0, 0}, "too-many",
            "there are more mistakes than " + std::to_string(kMostComplaints) + "; these are the first");
    }
}

}  // namespace campuswalk::config
