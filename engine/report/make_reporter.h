#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/report/reporter.h"

namespace campuswalk::engine {

/// Takes text as it is, ends of lines and all. Throws std::runtime_error when it can't be written.
using TextSink = std::function<void(std::string_view text)>;

/// What the places that reports go to differ in. Only `list` and `dot`, which people read, heed it.
struct ReportStyle {
    bool color = false;       ///< ANSI colours, for a terminal
    bool quiet = false;       ///< only what is not as it should be, and the last line
    std::string folder = {};  ///< the run's output folder as the user named it, to find images in
};

/// As the user writes them.
std::vector<std::string> reporter_names();

/// One of them, writing to `sink`. None for a name that isn't among them.
std::unique_ptr<Reporter> make_reporter(std::string_view name, TextSink sink, const ReportStyle& style = {});

}  // namespace campuswalk::engine
