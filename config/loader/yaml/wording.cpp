#include "config/loader/yaml/wording.h"

#include <array>
#include <charconv>

#include "scene/base/diagnostic.h"
#include "scene/base/utf8.h"

namespace campuswalk::config {

namespace {

constexpr std::size_t kMaxQuoteBytes = 60;
constexpr std::size_t kMaxComparableBytes = 64;
constexpr std::size_t kMaxListed = 25;
constexpr std::size_t kMaxCompared = 5000;

}  // namespace

std::string in_quotes(std::string_view text) {
    std::string shown = "'";
    std::size_t length = text.size();
    if (length > kMaxQuoteBytes) {
        length = kMaxQuoteBytes;
        while (length > 0 && scene::is_utf8_continuation(text[length])) {
            --length;  // not in the middle of a character
        }
    }
    for (const char c : text.substr(0, length)) {
        shown += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return shown + (length < text.size() ? "…'" : "'");
}

std::string listed(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size() && i < kMaxListed; ++i) {
        list += (i == 0 ? "" : ", ") + words[i];
    }
    return words.size() > kMaxListed ? list + ", …" : list;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
    return word.size() > kMaxComparableBytes || candidates.size() > kMaxCompared
               ? ""
               : scene::did_you_mean(word, candidates);
}

std::string suggestion_or_list(std::string_view word, const std::vector<std::string>& candidates) {
    std::string nearest = suggestion(word, candidates);
    if (!nearest.empty()) {
        return nearest;
    }
    return candidates.empty() ? "" : "; known here: " + listed(candidates);
}

std::string shown_number(double value) {
    std::array<char, 400> buffer{};
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed);
    return {buffer.data(), end.ptr};
}

}  // namespace campuswalk::config
