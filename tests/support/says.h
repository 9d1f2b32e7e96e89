#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace campuswalk::support {

/// Whether `names` are in the text from `at` on, in this order and not overlapping.
inline bool names_follow(const std::string& text, std::size_t at, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        at = text.find(name, at);
        if (at == std::string::npos) {
            return false;
        }
        at += name.size();
    }
    return true;
}

/// Matches a text that contains `names` in this order. What is between them is free.
inline testing::Matcher<std::string> mentions(const std::vector<std::string>& names) {
    return testing::Truly([names](const std::string& text) { return names_follow(text, 0, names); });
}

/// Matches one diagnostic that starts with `start` (place, severity, code) and contains `names` in this
/// order. The rest of its sentence is free, but there must be one.
inline testing::Matcher<std::string> says(const std::string& start,
                                          const std::vector<std::string>& names = {}) {
    return testing::Truly([head = start + ": ", names](const std::string& line) {
        const bool is_one_line = line.find('\n') >= line.size() - 1;
        return line.starts_with(head) && is_one_line && line.size() > head.size() + 1 &&
               names_follow(line, head.size(), names);
    });
}

}  // namespace campuswalk::support
