#include "scene/import/collada_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace campuswalk::scene {
namespace {

/// What stands between the first <name …> and its </name>; nullopt when there is none.
std::optional<std::string_view> element(std::string_view xml, std::string_view name) {
    const std::string open = "<" + std::string(name);
    for (std::size_t at = xml.find(open); at != std::string_view::npos; at = xml.find(open, at + 1)) {
        const std::size_t after = at + open.size();
        if (after >= xml.size() || std::string_view("> \t\r\n").find(xml[after]) == std::string_view::npos) {
            continue;  // a longer name
        }
        const std::size_t begin = xml.find('>', after);
        const std::size_t end = xml.find("</" + std::string(name), after);
        if (begin == std::string_view::npos || end == std::string_view::npos || end <= begin) {
            return std::nullopt;
        }
        return xml.substr(begin + 1, end - begin - 1);
    }
    return std::nullopt;
}

/// A number alone, but for white space about it.
std::optional<double> number_of(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    text = text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
        text.remove_prefix(1);  // allowed in XML, not by from_chars
    }
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
    return whole ? std::optional(number) : std::nullopt;
}

}  // namespace

ColladaGeography read_geography(std::span<const std::uint8_t> xml) {
    const std::string_view text(reinterpret_cast<const char*>(xml.data()), xml.size());
    const auto asset = element(text, "asset");  // the document's comes first
    const auto location = asset ? element(*asset, "geographic_location") : std::nullopt;
    if (!location) {
        return {};
    }
    const auto longitude = number_of(element(*location, "longitude").value_or(""));
    const auto latitude = number_of(element(*location, "latitude").value_or(""));
    const std::optional<std::string_view> altitude = element(*location, "altitude");
    const auto height = altitude ? number_of(*altitude) : 0.0;
    if (!longitude || !latitude || !height) {
        return {std::nullopt, "lacks a latitude or a longitude, or one is no number"};
    }
    if (std::abs(*latitude) > kMostLatitude || std::abs(*longitude) > kMostLongitude) {
        return {std::nullopt, "is not on the Earth: latitudes end at 90 degrees, longitudes at 180"};
    }
    return {GeographicPlace{*latitude, *longitude, *height, Eigen::Vector3d::Zero()}, ""};
}

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
