#include "scene/base/unicode_words.h"

#include <cstdlib>
#include <memory>
#include <vector>

#include <utf8proc.h>

#include "scene/base/utf8.h"

namespace campuswalk::scene {
namespace {

/// Empty if the text isn't UTF-8.
std::vector<utf8proc_int32_t> code_points(std::string_view text) {
    std::vector<utf8proc_int32_t> points;
    const auto* bytes = reinterpret_cast<const utf8proc_uint8_t*>(text.data());
    auto left = static_cast<utf8proc_ssize_t>(text.size());
    while (left > 0) {
        utf8proc_int32_t point = 0;
        const utf8proc_ssize_t length = utf8proc_iterate(bytes, left, &point);
        if (length <= 0) {
            return {};
        }
        points.push_back(point);
        bytes += length;
        left -= length;
    }
    return points;
}

void append(utf8proc_int32_t point, std::string& text) {
    utf8proc_uint8_t bytes[4];
    const utf8proc_ssize_t length = utf8proc_encode_char(point, bytes);
    text.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length));
}

bool is_letter_or_digit(utf8proc_int32_t point) {
    switch (utf8proc_category(point)) {
        case UTF8PROC_CATEGORY_LU:
        case UTF8PROC_CATEGORY_LL:
        case UTF8PROC_CATEGORY_LT:
        case UTF8PROC_CATEGORY_LM:
        case UTF8PROC_CATEGORY_LO:
        case UTF8PROC_CATEGORY_ND:
            return true;
        default:
            return false;
    }
}

bool is_mark(utf8proc_int32_t point) {
    const utf8proc_category_t category = utf8proc_category(point);
    return category == UTF8PROC_CATEGORY_MN || category == UTF8PROC_CATEGORY_MC;
}

}  // namespace

std::string normalized(std::string_view text) {
    std::string zero_ended(text);
    if (zero_ended.find('\0') != std::string::npos) {
        return zero_ended;
    }
    const auto free_text = [](utf8proc_uint8_t* bytes) { std::free(bytes); };
    const std::unique_ptr<utf8proc_uint8_t, decltype(free_text)> composed(
        utf8proc_NFC(reinterpret_cast<const utf8proc_uint8_t*>(zero_ended.c_str())), free_text);
    return composed ? std::string(reinterpret_cast<const char*>(composed.get())) : zero_ended;
}

bool is_id_word(std::string_view text) {
    const std::vector<utf8proc_int32_t> points = code_points(text);
    if (points.empty() || !is_letter_or_digit(points.front())) {
        return false;
    }
    bool ends_in_letter = false;
    for (const utf8proc_int32_t point : points) {
        const bool is_sign = point == '-' || point == '_' || point == '.';
        if (!is_sign && !is_letter_or_digit(point) && !is_mark(point)) {
            return false;
        }
        ends_in_letter = !is_sign;
    }
    return ends_in_letter;
}

bool is_unseen(char32_t code) {
    if (code < 0x80) {
        return controls_display(code);
    }
    constexpr char32_t kBlankBraille = 0x2800;
    const auto within = [code](char32_t first, char32_t last) { return code >= first && code <= last; };
    const auto point = static_cast<utf8proc_int32_t>(code);
    const utf8proc_property_t* properties = utf8proc_get_property(point);
    switch (utf8proc_category(point)) {
        case UTF8PROC_CATEGORY_CC:
        case UTF8PROC_CATEGORY_CS:
        case UTF8PROC_CATEGORY_ZL:
        case UTF8PROC_CATEGORY_ZP:
        case UTF8PROC_CATEGORY_ZS:
            return true;
        case UTF8PROC_CATEGORY_CF:  // all but signs that are drawn around numbers, such as U+06DD
            return properties->boundclass != UTF8PROC_BOUNDCLASS_PREPEND;
        case UTF8PROC_CATEGORY_CN:  // ignorable by their block, and those that are no characters
            return code == 0x2065 || within(0xFFF0, 0xFFF8) || within(0xE0000, 0xE0FFF) ||
                   within(0xFDD0, 0xFDEF) || (code & 0xFFFEU) == 0xFFFE;
        default:
            return code == kBlankBraille || properties->ignorable;
    }
}

std::string to_id_word(std::string_view text) {
    std::string word;
    bool gap = false;
    for (const utf8proc_int32_t point : code_points(normalized(text))) {
        if (is_mark(point) && !word.empty() && !gap) {
            append(point, word);
        } else if (is_letter_or_digit(point)) {
            word += gap && !word.empty() ? "-" : "";
            gap = false;
            append(utf8proc_tolower(point), word);
        } else {
            gap = true;
        }
    }
    return word;
}

}  // namespace campuswalk::scene
