#include "scene/import/collada_text.h"

#include <algorithm>

namespace campuswalk::scene {

void trim_element_starts(std::vector<std::uint8_t>& xml) {
    const auto is_space = [](std::uint8_t c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    std::size_t kept = 0;
    for (std::size_t i = 0; i < xml.size(); ++i) {
        xml[kept++] = xml[i];
        if (xml[i] == '>') {
            while (i + 1 < xml.size() && is_space(xml[i + 1])) {
                ++i;
            }
        }
    }
    xml.resize(kept);
}

}  // namespace campuswalk::scene
