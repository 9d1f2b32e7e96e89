#pragma once

#include <compare>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/base/diagnostic_code.h"

namespace campuswalk::scene {

/// A position in a user's file. Lines and columns count from 1; 0 means the file as a whole.
struct SourceMark {
    std::string file;  ///< as the user wrote it, relative to the working directory
    int line = 0;
    int column = 0;

    friend auto operator<=>(const SourceMark&, const SourceMark&) = default;
};

enum class Severity { error, warning };

/// An error or warning about an input file. Scripts match on `code`, which is stable; `message` says what is
/// wrong and what to do.
struct Diagnostic {
    Severity severity = Severity::error;
    SourceMark mark;
    DiagnosticCode code;
    std::string message;

    friend bool operator==(const Diagnostic&, const Diagnostic&) = default;
};

/// `file:line:col: error CODE: message`, without what it has none of.
std::string to_string(const Diagnostic& diagnostic);
/// The same of an error whose code is no diagnostic's, such as the failure of a walk.
std::string error_line(const SourceMark& mark, std::string_view code, const std::string& message);

/// The exception for bad input. Carries all errors of a file, found before anything runs.
class InputError : public std::runtime_error {
public:
    explicit InputError(std::vector<Diagnostic> diagnostics);
    InputError(SourceMark mark, DiagnosticCode code, std::string message);

    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

/// Collects diagnostics, so that all errors of a file are reported together.
class DiagnosticList {
public:
    void error(const SourceMark& mark, DiagnosticCode code, std::string message);
    void warning(const SourceMark& mark, DiagnosticCode code, std::string message);
    void append(const std::vector<Diagnostic>& diagnostics);

    bool has_errors() const;
    const std::vector<Diagnostic>& all() const { return diagnostics_; }

    /// Throws InputError with all diagnostics if one of them is an error.
    void throw_if_errors() const;

private:
    std::vector<Diagnostic> diagnostics_;
};

/// The candidate nearest to `word` by edit distance; empty if none is close enough to be a typo.
std::string_view nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// ` (did you mean 'x'?)` for the nearest candidate; empty if there is none.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace campuswalk::scene
