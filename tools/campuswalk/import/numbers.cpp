#include "tools/campuswalk/import/numbers.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools {

std::vector<double> numbers_in(const std::string& text, std::size_t count, const std::string& option) {
    std::vector<double> numbers;
    bool valid = true;
    for (std::string_view word : split(text, ',')) {
        while (word.starts_with(' ')) {
            word.remove_prefix(1);
        }
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        valid = valid && error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
        numbers.push_back(value);
    }
    if (!valid || numbers.size() != count) {
        throw error_about(option, "bad-value",
                          "'" + text + "' isn't " + std::to_string(count) + " numbers with commas between");
    }
    return numbers;
}

}  // namespace campuswalk::tools
