#include "scene/osm/read/tag_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "scene/base/ascii.h"

namespace campuswalk::scene::osm {
namespace {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') {
        text.remove_prefix(1);
    }
    while (!text.empty() && text.back() == ' ') {
        text.remove_suffix(1);
    }
    return text;
}

/// Takes a number off the front.
std::optional<double> take_number(std::string_view& text) {
    text = trimmed(text);
    std::string digits(text.substr(0, 40));
    std::ranges::replace(digits, ',', '.');
    double value = 0.0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
    if (error != std::errc() || !std::isfinite(value)) {
        return std::nullopt;
    }
    text.remove_prefix(static_cast<std::size_t>(end - digits.data()));
    text = trimmed(text);
    return value;
}

std::optional<double> unit_of(std::string_view unit) {
    constexpr double kFoot = 0.3048;
    constexpr double kInch = 0.0254;
    constexpr std::array<std::pair<std::string_view, double>, 20> kUnits = {
        {{"", 1.0},       {"m", 1.0},        {"metre", 1.0},        {"metres", 1.0}, {"meter", 1.0},
         {"meters", 1.0}, {"km", 1000.0},    {"kilometre", 1000.0}, {"cm", 0.01},    {"centimetre", 0.01},
         {"mm", 0.001},   {"ft", kFoot},     {"foot", kFoot},       {"feet", kFoot}, {"in", kInch},
         {"inch", kInch}, {"inches", kInch}, {"\"", kInch},         {"''", kInch},   {"yd", 3.0 * kFoot}}};
    const auto* found = std::ranges::find(kUnits, unit, &std::pair<std::string_view, double>::first);
    return found == kUnits.end() ? std::nullopt : std::optional(found->second);
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
}

/// Of a list the first value, without what says that it is a guess, in lower case with plain quotes.
std::string plain_length(std::string_view value) {
    std::string text(trimmed(value.substr(0, value.find(';'))));
    for (const auto& [quote, plain] : std::array<std::pair<std::string_view, std::string_view>, 4>{
             {{"\u2019", "'"}, {"\u2032", "'"}, {"\u201D", "\""}, {"\u2033", "\""}}}) {
        replace_all(text, quote, plain);
    }
    text = to_lower(text);
    for (const std::string_view guess : {"~", "ca.", "ca ", "c.", "+"}) {
        if (text.starts_with(guess)) {
            return std::string(trimmed(std::string_view(text).substr(guess.size())));
        }
    }
    return text;
}

std::optional<double> feet_and_inches(double feet, std::string_view rest) {
    double length = feet * 0.3048;
    rest.remove_prefix(1);
    if (trimmed(rest).empty()) {
        return length;
    }
    const auto inches = take_number(rest);
    if (!inches || (rest != "\"" && rest != "''" && !rest.empty())) {
        return std::nullopt;
    }
    return length + *inches * 0.0254;
}

int hex_digit(char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

std::optional<Color> hex_color(std::string_view digits) {
    if (digits.size() != 3 && digits.size() != 6) {
        return std::nullopt;
    }
    const std::size_t each = digits.size() / 3;
    Color color{};
    for (std::size_t i = 0; i < 3; ++i) {
        const int high = hex_digit(digits[i * each]);
        const int low = hex_digit(digits[i * each + each - 1]);
        if (high < 0 || low < 0) {
            return std::nullopt;
        }
        color[i] = static_cast<std::uint8_t>(16 * high + low);
    }
    return color;
}

struct NamedColor {
    std::string_view name;
    Color color;
};

// The names of CSS that buildings have. Who maps a red roof means a red of roofs: the pure colours are those
// of paint. Hexadecimal colours are taken as they are.
constexpr std::array<NamedColor, 40> kColors = {{
    {"aqua", {130, 200, 204}},      {"azure", {240, 255, 255}},     {"beige", {245, 245, 220}},
    {"black", {40, 40, 42}},        {"blue", {70, 100, 160}},       {"brown", {165, 42, 42}},
    {"burlywood", {222, 184, 135}}, {"chocolate", {210, 105, 30}},  {"cornsilk", {255, 248, 220}},
    {"cream", {255, 253, 208}},     {"darkgray", {169, 169, 169}},  {"darkgreen", {0, 100, 0}},
    {"darkgrey", {169, 169, 169}},  {"darkred", {139, 0, 0}},       {"dimgray", {105, 105, 105}},
    {"firebrick", {178, 34, 34}},   {"fuchsia", {190, 90, 160}},    {"gold", {255, 215, 0}},
    {"gray", {128, 128, 128}},      {"green", {84, 128, 84}},       {"grey", {128, 128, 128}},
    {"indianred", {205, 92, 92}},   {"ivory", {255, 255, 240}},     {"khaki", {240, 230, 140}},
    {"lightgray", {211, 211, 211}}, {"lightgrey", {211, 211, 211}}, {"lime", {150, 196, 90}},
    {"maroon", {118, 48, 44}},      {"navy", {0, 0, 128}},          {"olive", {128, 128, 0}},
    {"orange", {216, 150, 84}},     {"pink", {255, 192, 203}},      {"purple", {116, 80, 124}},
    {"red", {178, 64, 52}},         {"salmon", {250, 128, 114}},    {"silver", {192, 192, 192}},
    {"tan", {210, 180, 140}},       {"teal", {0, 128, 128}},        {"white", {240, 238, 232}},
    {"yellow", {232, 208, 120}},
}};

constexpr std::array<NamedColor, 22> kMaterials = {{
    {"brick", {158, 89, 69}},       {"bronze", {140, 100, 60}},    {"cement_block", {170, 168, 160}},
    {"concrete", {176, 172, 164}},  {"copper", {102, 150, 132}},   {"eternit", {150, 152, 150}},
    {"glass", {140, 170, 186}},     {"grass", {110, 142, 80}},     {"gravel", {160, 152, 140}},
    {"limestone", {214, 204, 178}}, {"marble", {226, 224, 218}},   {"metal", {168, 174, 178}},
    {"plaster", {222, 212, 190}},   {"roof_tiles", {156, 82, 60}}, {"sandstone", {206, 178, 134}},
    {"slate", {92, 100, 110}},      {"steel", {150, 158, 164}},    {"stone", {182, 174, 158}},
    {"tar_paper", {84, 82, 80}},    {"tile", {170, 110, 90}},      {"timber_framing", {206, 190, 160}},
    {"wood", {146, 108, 70}},
}};

template <std::size_t Count>
std::optional<Color> named(const std::array<NamedColor, Count>& list, std::string_view name) {
    const auto* found = std::ranges::find(list, name, &NamedColor::name);
    return found == list.end() ? std::nullopt : std::optional(found->color);
}

std::string lower(std::string_view text) {
    std::string result = to_lower(std::string(text));
    std::ranges::replace(result, ' ', '_');
    return result;
}

}  // namespace

std::optional<double> length_of(std::string_view value) {
    constexpr double kMax = 100'000.0;
    const std::string text = plain_length(value);
    std::string_view rest = text;
    const auto number = take_number(rest);
    if (!number) {
        return std::nullopt;
    }
    std::optional<double> length;
    if (rest.starts_with('\'') && !rest.starts_with("''")) {
        length = feet_and_inches(*number, rest);
    } else if (const auto unit = unit_of(rest)) {
        length = *number * *unit;
    }
    return length && std::abs(*length) <= kMax ? length : std::nullopt;
}

std::optional<double> length_of(const Tags& tags, std::string_view key) {
    return length_of(tags.get(key));
}

std::optional<double> number_of(const Tags& tags, std::string_view key) {
    std::string_view value = tags.get(key);
    const auto number = take_number(value);
    return number && (value.empty() || value.front() == ';' || value.front() == '-') ? number : std::nullopt;
}

std::optional<double> direction_of(const Tags& tags, std::string_view key) {
    constexpr std::array<std::string_view, 16> kWinds = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                                         "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};
    const std::string_view value = trimmed(tags.get(key));
    if (const auto* wind = std::ranges::find(kWinds, value); wind != kWinds.end()) {
        return 22.5 * static_cast<double>(wind - kWinds.begin());
    }
    return degrees_of(tags, key);
}

std::optional<double> degrees_of(const Tags& tags, std::string_view key) {
    std::string_view value = tags.get(key);
    const auto number = take_number(value);
    return number && std::abs(*number) <= 360.0 && (value.empty() || value == "\u00B0") ? number
                                                                                        : std::nullopt;
}

bool affirmed(const Tags& tags, std::string_view key) {
    const std::string_view value = tags.get(key);
    return !value.empty() && value != "no" && value != "none" && value != "0" && value != "false";
}

std::optional<Color> color_of(std::string_view value) {
    value = trimmed(value);
    return value.starts_with('#') ? hex_color(value.substr(1)) : named(kColors, lower(value));
}

std::optional<Color> color_of(const Tags& tags, std::string_view key, std::string_view american_key) {
    const auto color = color_of(tags.get(key));
    return color ? color : color_of(tags.get(american_key));
}

std::optional<Color> material_color(std::string_view material) {
    return named(kMaterials, lower(material));
}

}  // namespace campuswalk::scene::osm
