#include "engine/report/github_text.h"

#include "scene/base/printable.h"

namespace campuswalk::engine {

std::string github_escaped(std::string_view text, bool in_property) {
    std::string out;
    std::size_t start = 0;
    for (std::size_t end = 0; end != std::string_view::npos; start = end + 1) {
        end = text.find('\n', start);
        out += start == 0 ? "" : "%0A";
        for (const char c : scene::printable(text.substr(start, end - start))) {
            switch (c) {
                case '%':
                    out += "%25";
                    break;
                case ':':
                    out += in_property ? "%3A" : ":";
                    break;
                case ',':
                    out += in_property ? "%2C" : ",";
                    break;
                default:
                    out += c;
            }
        }
    }
    return out;
}

}  // namespace campuswalk::engine
