#include "scene/import/source/stl_text.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "scene/base/ascii.h"
#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene {
namespace {

constexpr std::size_t kHeader = 80;  // bytes before the number of triangles
constexpr std::size_t kTriangle = 50;

/// Text begins with "solid", and says "facet" or "endsolid" soon.
bool is_text(const std::vector<std::uint8_t>& stl) {
    constexpr std::size_t kBeginning = 4096;
    const std::string beginning = lower_case(std::string(
        stl.begin(), stl.begin() + static_cast<std::ptrdiff_t>(std::min(stl.size(), kBeginning))));
    const std::size_t first = std::min(beginning.find_first_not_of(" \t\r\n"), beginning.size());
    const bool has_word =
        beginning.find("facet") != std::string::npos || beginning.find("endsolid") != std::string::npos;
    return beginning.compare(first, 5, "solid") == 0 && has_word && beginning.find('\0') == std::string::npos;
}

void cut_binary(std::vector<std::uint8_t>& stl) {
    std::uint32_t triangles = 0;
    if (stl.size() < kHeader + sizeof triangles) {
        return;
    }
    std::memcpy(&triangles, stl.data() + kHeader, sizeof triangles);
    const std::size_t size = kHeader + sizeof triangles + kTriangle * triangles;
    if (size < stl.size()) {
        stl.resize(size);
    }
}

/// [first, last) is a line without its end.
void normalize_line(std::uint8_t* first, std::uint8_t* last) {
    while (first != last && is_blank(static_cast<char>(*first))) {
        ++first;
    }
    while (first != last && is_blank(static_cast<char>(last[-1]))) {
        --last;
    }
    constexpr std::string_view kSolid = "solid";
    const auto lower = [](std::uint8_t c) {
        return static_cast<std::uint8_t>(to_lower(static_cast<char>(c)));
    };
    auto* const word_end = first + std::min<std::ptrdiff_t>(last - first, kSolid.size());
    const bool is_solid = std::equal(first, word_end, kSolid.begin(), kSolid.end(),
                                     [&](std::uint8_t c, char word) { return lower(c) == word; });
    if (!is_solid) {
        std::transform(first, last, first, lower);
        return;
    }
    std::transform(first, word_end, first, lower);
    auto* name =
        std::find_if_not(word_end, last, [](std::uint8_t c) { return is_blank(static_cast<char>(c)); });
    std::replace_if(
        name, last, [](std::uint8_t c) { return is_blank(static_cast<char>(c)); },
        static_cast<std::uint8_t>(kStlSpace));
}

}  // namespace

void normalize_stl(std::vector<std::uint8_t>& stl) {
    if (!is_text(stl)) {
        cut_binary(stl);
        return;
    }
    std::uint8_t* const end = stl.data() + stl.size();
    for (std::uint8_t* line = stl.data(); line < end;) {
        std::uint8_t* const line_end = std::find(line, end, '\n');
        normalize_line(line, line_end);
        line = line_end == end ? end : line_end + 1;
    }
}

std::string name_of_solid(std::string name) {
    std::ranges::replace(name, kStlSpace, ' ');
    return name;
}

}  // namespace campuswalk::scene
