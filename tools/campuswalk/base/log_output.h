#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace spdlog {
class logger;
}

namespace campuswalk::tools {

/// Writes text to the terminal, to a file or to both, through spdlog, which nothing else uses. Words in it
/// have passed scene::printable() where they became part of it, so that a file is as harmless as a terminal.
class LogOutput {
public:
    /// Replaces `file`, unless it is a stream. Throws std::runtime_error when it can't be opened.
    LogOutput(bool to_terminal, const std::optional<std::filesystem::path>& file);

    /// Throws std::runtime_error when the text can't be written; for a file perhaps only at `flush`.
    void write(std::string_view text);
    /// The same with a line end.
    void line(std::string_view text) { write(std::string(text) + "\n"); }
    /// Everything is written when this returns; throws like `write`.
    void flush();

private:
    bool to_terminal_;
    std::shared_ptr<spdlog::logger> logger_;
};

}  // namespace campuswalk::tools
