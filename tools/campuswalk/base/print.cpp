#include "tools/campuswalk/base/print.h"

#include <cstdarg>
#include <cstdio>

#include "scene/base/printable.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools {

namespace {

void write_line(std::string_view line, std::FILE* stream) {
    const std::string safe = scene::printable(line) + "\n";
    std::fwrite(safe.data(), 1, safe.size(), stream);  // check_standard_output() notices failures
}

std::string formatted(const char* format, std::va_list arguments) {
    std::va_list again;
    va_copy(again, arguments);
    const int size = std::vsnprintf(nullptr, 0, format, again);
    va_end(again);
    std::string text(static_cast<std::size_t>(size > 0 ? size : 0), '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, arguments);
    return text;
}

}  // namespace

void print_line(const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    write_line(formatted(format, arguments), stdout);
    va_end(arguments);
}

void print_lines(std::string_view text) {
    const bool ended = text.ends_with('\n');
    for (const std::string_view line : split(ended ? text.substr(0, text.size() - 1) : text, '\n')) {
        write_line(line, stdout);
    }
}

void print_commands(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stdout);
}

void print_error_line(std::string_view line) {
    write_line(line, stderr);
}

}  // namespace campuswalk::tools
