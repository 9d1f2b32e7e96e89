#include "config/loader/complaint_order.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace campuswalk::config {

using scene::Diagnostic;

namespace {

/// A file that is included twice is read twice; its mistakes are told once.
void drop_repeated(std::vector<Diagnostic>& diagnostics) {
    std::set<std::string> told;
    std::erase_if(diagnostics, [&](const Diagnostic& d) { return !told.insert(scene::to_string(d)).second; });
}

}  // namespace

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
    drop_repeated(sorted);
    throw scene::InputError(std::move(sorted));
}

}  // namespace campuswalk::config
