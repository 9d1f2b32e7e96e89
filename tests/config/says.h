#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace campuswalk::config::test {

/// A diagnostic that starts so (place, severity, code) and has these in this order, such as the names it
/// quotes. Its sentence is free.
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
