#include "config/loader/yaml/diagnostics.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace campuswalk::config {

using scene::Diagnostic;

namespace {

constexpr std::size_t kMaxDiagnostics = 200;

}  // namespace

bool is_full(const scene::DiagnosticList& diagnostics) {
    return diagnostics.all().size() >= kMaxDiagnostics;
}

void add_diagnostic(scene::DiagnosticList& diagnostics, const scene::SourceMark& mark,
                    scene::DiagnosticCode code, std::string message) {
    if (is_full(diagnostics)) {
        return;
    }
    diagnostics.error(mark, code, std::move(message));
    if (is_full(diagnostics)) {
        diagnostics.error(
            {mark.file, 0, 0}, "too-many",
            "too many errors; only the first " + std::to_string(kMaxDiagnostics) + " are shown");
    }
}

void throw_in_order(const scene::DiagnosticList& diagnostics, const scene::SourceMark& first) {
    if (!diagnostics.has_errors()) {
        return;
    }
    std::vector<Diagnostic> sorted = diagnostics.all();
    std::vector<std::string> files = {first.file};
    for (const Diagnostic& diagnostic : sorted) {
        if (std::ranges::find(files, diagnostic.mark.file) == files.end()) {
            files.push_back(diagnostic.mark.file);
        }
    }
    std::ranges::stable_sort(sorted, {}, [&](const Diagnostic& diagnostic) {
        const scene::SourceMark& mark = diagnostic.mark;
        return std::tuple(std::ranges::find(files, mark.file) - files.begin(), mark.line, mark.column);
    });
    std::set<std::string> reported;
    std::erase_if(sorted,
                  [&](const Diagnostic& each) { return !reported.insert(scene::to_string(each)).second; });
    throw scene::InputError(std::move(sorted));
}

}  // namespace campuswalk::config
