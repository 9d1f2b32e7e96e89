#include "scene/import/source/mtl_text.h"

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene {
namespace {

std::vector<std::string_view> words_of(std::string_view line) {
    constexpr std::string_view kSpace = " \t\r";
    std::vector<std::string_view> words;
    for (std::size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;
         at = line.find_first_not_of(kSpace, at)) {
        const std::size_t end = std::min(line.find_first_of(kSpace, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

bool is_map(std::string_view word) {
    const std::string name = lower_case(std::string(word));
    return name.starts_with("map_") || name == "bump" || name == "norm" || name == "disp" ||
           name == "decal" || name == "refl";
}

/// Whether a number that follows the option at words[option] isn't `usual`.
bool differs(const std::vector<std::string_view>& words, std::size_t option, double usual) {
    for (std::size_t i = option + 1; i < words.size() && i <= option + 3; ++i) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(words[i].data(), words[i].data() + words[i].size(), value);
        if (error != std::errc() || end != words[i].data() + words[i].size()) {
            return false;
        }
        if (value != usual) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool moves_images(std::span<const std::uint8_t> mtl) {
    std::string_view text(reinterpret_cast<const char*>(mtl.data()), mtl.size());
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::vector<std::string_view> words = words_of(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (words.empty() || !is_map(words.front())) {
            continue;
        }
        for (std::size_t i = 1; i < words.size(); ++i) {
            if ((words[i] == "-s" && differs(words, i, 1.0)) ||
                ((words[i] == "-o" || words[i] == "-t") && differs(words, i, 0.0))) {
                return true;
            }
        }
    }
    return false;
}

}  // namespace campuswalk::scene
