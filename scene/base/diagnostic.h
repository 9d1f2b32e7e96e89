#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::scene {

/// Where in a user's file something was said. Lines and columns count from 1; 0 means "the whole file".
struct SourceMark {
    std::string file;  ///< as the user wrote it, relative to the working directory
    int line = 0;
    int column = 0;
};

enum class Severity { error, warning };

/// One diagnostic about an input file. `code` is stable (scripts match on it), `message` says what to do.
struct Diagnostic {
    Severity severity = Severity::error;
    SourceMark mark;
    std::string code;
    std::string message;
};

/// `file:line:col: error CODE: message`, without line and column where there is none.
std::string to_string(const Diagnostic& diagnostic);

/// The one exception for bad input: everything that is wrong with a file, found before anything is run.
class InputError : public std::runtime_error {
public:
    explicit InputError(std::vector<Diagnostic> diagnostics);
    InputError(SourceMark mark, std::string code, std::string message);

    const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

/// Collects diagnostics so that a file's mistakes are reported together.
class DiagnosticList {
public:
    void error(const SourceMark& mark, std::string code, std::string message);
    void warning(const SourceMark& mark, std::string code, std::string message);
    void append(const std::vector<Diagnostic>& diagnostics);

    bool has_errors() const;
    const std::vector<Diagnostic>& all() const { return diagnostics_; }

    /// Throws InputError with everything collected when there is at least one error.
    void throw_if_errors() const;

private:
    std::vector<Diagnostic> diagnostics_;
};

/// The candidate nearest to `word` by edit distance, empty when none is near enough to be a typing mistake.
std::string_view nearest_word(std::string_view word, const std::vector<std::string>& candidates);

/// ` (did you mean 'x'?)` for the nearest candidate, or an empty string.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace campuswalk::scene
