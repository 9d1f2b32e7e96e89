#include "scene/base/diagnostic.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace campuswalk::scene {

namespace {

std::string joined(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        text += (text.empty() ? "" : "\n") + to_string(diagnostic);
    }
    return text;
}

std::string line_of(Severity severity, const SourceMark& mark, std::string_view code,
                    const std::string& message) {
    std::string text = mark.file;
    if (mark.line > 0) {
        text += ":" + std::to_string(mark.line) + ":" + std::to_string(mark.column);
    }
    text += text.empty() ? "" : ": ";
    text += severity == Severity::error ? "error" : "warning";
    text += code.empty() ? "" : " " + std::string(code);
    return text + ": " + message;
}

/// Optimal string alignment distance: Levenshtein distance plus transpositions of adjacent characters, the
/// most common typo.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> two_up(b.size() + 1);
    std::vector<std::size_t> above(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::swap(two_up, above);
        std::swap(above, row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], two_up[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

}  // namespace

std::string to_string(const Diagnostic& diagnostic) {
    return line_of(diagnostic.severity, diagnostic.mark, diagnostic.code.text(), diagnostic.message);
}

std::string error_line(const SourceMark& mark, std::string_view code, const std::string& message) {
    return line_of(Severity::error, mark, code, message);
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(joined(diagnostics)), diagnostics_(std::move(diagnostics)) {}

InputError::InputError(SourceMark mark, DiagnosticCode code, std::string message)
    : InputError(std::vector<Diagnostic>{{Severity::error, std::move(mark), code, std::move(message)}}) {}

void DiagnosticList::error(const SourceMark& mark, DiagnosticCode code, std::string message) {
    diagnostics_.push_back({Severity::error, mark, code, std::move(message)});
}

void DiagnosticList::warning(const SourceMark& mark, DiagnosticCode code, std::string message) {
    diagnostics_.push_back({Severity::warning, mark, code, std::move(message)});
}

void DiagnosticList::append(const std::vector<Diagnostic>& diagnostics) {
    diagnostics_.insert(diagnostics_.end(), diagnostics.begin(), diagnostics.end());
}

bool DiagnosticList::has_errors() const {
    return std::ranges::any_of(diagnostics_,
                               [](const Diagnostic& d) { return d.severity == Severity::error; });
}

void DiagnosticList::throw_if_errors() const {
    if (has_errors()) {
        throw InputError(diagnostics_);
    }
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
    // With more than a third of the letters wrong it is another word, not a typo.
    const std::size_t allowed = word.size() < 2 ? 0 : std::max<std::size_t>(1, word.size() / 3);
    constexpr std::size_t kLongestTypo = 300;  // a distance takes time by the square of the length
    std::string_view best;
    if (word.size() > kLongestTypo) {
        return best;
    }
    std::size_t best_distance = allowed + 1;
    for (const std::string& candidate : candidates) {
        if (candidate.size() + best_distance <= word.size() ||
            word.size() + best_distance <= candidate.size()) {
            continue;  // the distance is at least the difference of the lengths
        }
        if (const std::size_t distance = edit_distance(word, candidate); distance < best_distance) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string_view nearest = nearest_word(word, candidates);
    return nearest.empty() ? "" : " (did you mean '" + std::string(nearest) + "'?)";
}

}  // namespace campuswalk::scene
