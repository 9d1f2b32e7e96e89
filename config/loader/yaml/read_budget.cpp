#include "config/loader/yaml/read_budget.h"

namespace campuswalk::config {

std::size_t count_marks(std::string_view text) {
    constexpr std::string_view kAlways = ",:[{&*!";
    constexpr std::string_view kBeforeSpace = "-?";
    std::size_t marks = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool spaced = i + 1 == text.size() || text[i + 1] == ' ' || text[i + 1] == '\n';
        if (kAlways.find(text[i]) != kAlways.npos ||
            (spaced && kBeforeSpace.find(text[i]) != kBeforeSpace.npos)) {
            ++marks;
        }
    }
    return marks;
}

bool ReadBudget::admit(std::string_view text, const std::string& file, scene::DiagnosticList& diagnostics) {
    const auto refuse = [&](const std::string& message) {
        diagnostics.error({file, 0, 0}, "too-large", message);
        return false;
    };
    const std::size_t marks = count_marks(text);
    if (marks > kMaxMarks) {
        return refuse("the file has " + std::to_string(marks) +
                      " commas, colons, brackets and other marks of values; the limit is " +
                      std::to_string(kMaxMarks) + "; split it");
    }
    bytes_ += text.size();
    marks_ += marks;
    if (bytes_ > kMaxBytes || marks_ > kMaxMarksOfAll) {
        return refuse("with this file, " + std::to_string(bytes_) + " bytes with " + std::to_string(marks_) +
                      " marks of values were read, counting a file each time; the limits are " +
                      std::to_string(kMaxBytes) + " and " + std::to_string(kMaxMarksOfAll) +
                      "; run fewer walks at a time, for example with --shard, or make the files smaller");
    }
    return true;
}

}  // namespace campuswalk::config
