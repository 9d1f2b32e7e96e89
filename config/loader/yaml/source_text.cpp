#include "config/loader/yaml/source_text.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include "scene/base/utf8.h"
#include "scene/base/why_unreadable.h"

namespace campuswalk::config {

using scene::DiagnosticList;
using scene::SourceMark;
using scene::utf8_length;

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// An invalid character: where it is, and why it is invalid.
struct TextFault {
    int line = 0;
    int column = 0;
    std::string message;
};

/// What is wrong with the character at `at`; empty if it is valid there.
std::string fault_at(std::string_view text, std::size_t at, bool indenting, bool line_starts) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte == '\t' && indenting) {
        return "a tab can't indent a line; use spaces";
    }
    if (byte == '%' && line_starts) {
        return "a line can't start with '%' (the YAML parser would skip it); put the text in quotes";
    }
    if ((byte < 0x20 && byte != '\t' && byte != '\n') || byte == 0x7F) {
        return "control character (byte " + std::to_string(byte) +
               "); remove it, or check that this is a text file";
    }
    if (utf8_length(text, at) == 0) {
        return "invalid UTF-8; save the file as UTF-8";
    }
    return "";
}

/// The first invalid character.
std::optional<TextFault> first_fault(std::string_view text) {
    int line = 1;
    int column = 1;
    bool indenting = true;
    for (std::size_t at = 0; at < text.size(); at += utf8_length(text, at)) {
        if (std::string fault = fault_at(text, at, indenting, column == 1); !fault.empty()) {
            return TextFault{line, column, std::move(fault)};
        }
        const char c = text[at];
        line += c == '\n' ? 1 : 0;
        column = c == '\n' ? 1 : column + 1;
        indenting = c == '\n' || (indenting && c == ' ');
    }
    return std::nullopt;
}

/// Drops the byte order mark and the `\r` of `\r\n`.
std::string with_plain_lines(std::string_view bytes) {
    if (bytes.starts_with(kByteOrderMark)) {
        bytes.remove_prefix(kByteOrderMark.size());
    }
    std::string text;
    text.reserve(bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (bytes[i] != '\r' || i + 1 >= bytes.size() || bytes[i + 1] != '\n') {
            text += bytes[i];
        }
    }
    return text;
}

}  // namespace

std::string shown_path(const std::filesystem::path& path) {
    return path.lexically_normal().generic_string();
}

std::optional<std::string> read_bytes(const std::filesystem::path& path, const SourceMark& named_at,
                                      DiagnosticList& diagnostics) {
    const std::string shown = shown_path(path);
    const auto missing = [&](const std::string& why) {
        diagnostics.error(named_at, "missing-file", named_at.line > 0 ? "'" + shown + "': " + why : why);
        return std::nullopt;
    };
    if (const std::string why = scene::why_unreadable(path); !why.empty()) {
        return missing(why);
    }
    std::error_code error;
    if (const auto size = std::filesystem::file_size(path, error); !error && size > kMaxSourceBytes) {
        diagnostics.error({shown, 0, 0}, "too-large",
                          "the file has " + std::to_string(size) + " bytes; the limit is " +
                              std::to_string(kMaxSourceBytes));
        return std::nullopt;
    }
    std::ifstream in(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in || in.bad()) {
        return missing("it can't be read");
    }
    return bytes;
}

std::optional<std::string> read_source(const std::filesystem::path& path, const SourceMark& named_at,
                                       DiagnosticList& diagnostics) {
    const std::optional<std::string> bytes = read_bytes(path, named_at, diagnostics);
    if (!bytes) {
        return std::nullopt;
    }
    std::string text = with_plain_lines(*bytes);
    if (const auto fault = first_fault(text)) {
        diagnostics.error({shown_path(path), fault->line, fault->column}, "yaml-syntax", fault->message);
        return std::nullopt;
    }
    return text;
}

}  // namespace campuswalk::config
