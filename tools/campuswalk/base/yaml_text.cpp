#include "tools/campuswalk/base/yaml_text.h"

#include "scene/base/printable.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools {

std::string yaml_string(const std::string& text) {
    return json_text(text);
}

std::string globs_yaml(const std::vector<std::string>& globs) {
    constexpr std::size_t kLineLength = 90;
    if (globs.size() == 1) {
        return yaml_string(globs[0]);
    }
    std::string list = "[";
    std::size_t line = 0;
    for (std::size_t i = 0; i < globs.size(); ++i) {
        const std::string glob = yaml_string(globs[i]) + (i + 1 < globs.size() ? "," : "]");
        const bool wraps = line > 0 && line + glob.size() > kLineLength;
        list += i == 0 ? "" : wraps ? "\n       " : " ";
        list += glob;
        line = (wraps ? 0 : line) + glob.size() + 1;
    }
    return list;
}

std::string yaml_comment(const std::string& text) {
    return text.empty() ? "" : "  # " + scene::printable(text);
}

}  // namespace campuswalk::tools
