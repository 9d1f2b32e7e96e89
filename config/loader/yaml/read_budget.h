#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/base/diagnostic.h"

namespace campuswalk::config {

/// The characters of a text that may begin or separate values in YAML or JSON: commas, colons, opening
/// brackets, and dashes and the like before a space. A value has at least one, so that this, which takes no
/// memory, says how much a parser may take, before it does.
std::size_t count_marks(std::string_view text);

/// Marks that a file may have: the parser keeps up to 300 bytes for each. Those of a million values, which is
/// the most that is read, are fewer, unless they have text with many commas.
inline constexpr std::size_t kMaxMarks = 1'500'000;

/// What all files of a run may have together. Of files that are read several times, such as profiles, each
/// time counts: it is the work that is limited. Ten thousand walks of a hundred steps take a tenth of it.
class ReadBudget {
public:
    static constexpr std::size_t kMaxBytes = 300'000'000;
    static constexpr std::size_t kMaxMarksOfAll = 30'000'000;

    /// Whether the text of a file may be parsed, too; reports too-large in the file.
    bool admit(std::string_view text, const std::string& file, scene::DiagnosticList& diagnostics);

private:
    std::size_t bytes_ = 0;
    std::size_t marks_ = 0;
};

}  // namespace campuswalk::config
