#include "scene/base/glob.h"

#include <algorithm>
#include <optional>

#include "scene/base/utf8.h"

namespace campuswalk::scene {
namespace {

constexpr std::size_t kNone = std::string_view::npos;

/// The result of matching a character class, `[…]`.
struct ClassMatch {
    bool matches = false;
    std::size_t end = 0;  ///< one past the closing bracket
};

/// The class starts at glob[at] == '['. nullopt if the bracket is never closed: it is then a literal.
std::optional<ClassMatch> match_class(std::string_view glob, std::size_t at, char c,
                                      std::uint64_t& compared) {
    std::size_t i = at + 1;
    const bool negated = i < glob.size() && (glob[i] == '!' || glob[i] == '^');
    i += negated ? 1 : 0;
    bool found = false;
    for (bool first = true; i < glob.size() && (first || glob[i] != ']'); first = false) {
        const auto low = static_cast<unsigned char>(glob[i]);
        auto high = low;
        if (i + 2 < glob.size() && glob[i + 1] == '-' && glob[i + 2] != ']') {
            high = static_cast<unsigned char>(glob[i + 2]);
            i += 2;
        }
        const auto value = static_cast<unsigned char>(c);
        found = found || (low <= value && value <= high);
        ++i;
    }
    compared += i - at;
    if (i >= glob.size()) {
        return std::nullopt;
    }
    return ClassMatch{found != negated, i + 1};
}

/// Matches one character against the glob's item at `at`. Returns the start of the next item, or kNone.
std::size_t match_one(std::string_view glob, std::size_t at, char c, std::uint64_t& compared) {
    ++compared;
    if (at >= glob.size()) {
        return kNone;
    }
    if (glob[at] == '[') {
        if (const auto match = match_class(glob, at, c, compared)) {
            return match->matches ? match->end : kNone;
        }
    }
    if (glob[at] == '\\' && at + 1 < glob.size()) {
        return glob[at + 1] == c ? at + 2 : kNone;
    }
    return glob[at] == '?' || glob[at] == c ? at + 1 : kNone;
}

}  // namespace

bool glob_matches(std::string_view glob, std::string_view name) {
    std::uint64_t ignored = 0;
    return glob_matches(glob, name, ignored);
}

// Backtracks to the last `*` only: O(name x glob) for any pattern.
bool glob_matches(std::string_view glob, std::string_view name, std::uint64_t& compared) {
    std::size_t at = 0;
    std::size_t i = 0;
    std::size_t after_star = kNone;
    std::size_t star_end = 0;
    while (i < name.size()) {
        if (at < glob.size() && glob[at] == '*') {
            after_star = ++at;
            star_end = i;
            continue;
        }
        const std::size_t next = match_one(glob, at, name[i], compared);
        if (next != kNone) {
            at = next;
            ++i;
        } else if (after_star != kNone) {
            at = after_star;
            i = ++star_end;
        } else {
            return false;
        }
    }
    while (at < glob.size() && glob[at] == '*') {
        ++at;
    }
    return at == glob.size();
}

std::string glob_for(std::string_view name) {
    std::string glob;
    while (!name.empty()) {
        const std::size_t bytes = utf8_length(name, 0);
        const char c = name.front();
        const bool is_control = bytes == 1 && (static_cast<unsigned char>(c) < 0x20 || c == '\x7f');
        if (bytes == 0 || is_control) {
            glob += '?';
        } else {
            glob += c == '*' || c == '?' || c == '[' || c == '\\' ? "\\" : "";
            glob += name.substr(0, bytes);
        }
        name.remove_prefix(std::max<std::size_t>(1, bytes));
    }
    return glob;
}

}  // namespace campuswalk::scene
