#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace campuswalk::config::test {

/// Matches a diagnostic that starts with `start` (place, severity, code) and contains `names` in this order.
/// The rest of its sentence is free.
inline testing::Matcher<std::string> says(const std::string& start,
                                          const std::vector<std::string>& names = {}) {
    return testing::Truly([start, names](const std::string& line) {
        if (!line.starts_with(start + ": ") || line.find('\n') < line.size() - 1) {
            return false;
        }
        std::size_t at = start.size();
        for (const std::string& name : names) {
            at = line.find(name, at);
            if (at == std::string::npos) {
                return false;
            }
            at += name.size();
        }
        return true;
    });
}

}  // namespace campuswalk::config::test
