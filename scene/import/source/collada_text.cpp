#include "scene/import/source/collada_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <pugixml.hpp>

#include "scene/import/source/collada_fault.h"

namespace campuswalk::scene {
namespace {

/// The whole text as a number; white space around it is allowed.
std::optional<double> number_of(std::string_view text) {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    text = text.substr(first, text.find_last_not_of(kSpace) + 1 - first);
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
        text.remove_prefix(1);  // valid in XML, but not for from_chars
    }
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
    return whole ? std::optional(number) : std::nullopt;
}

ColladaGeography geography_of(const pugi::xml_document& document) {
    // Inside <coverage> in COLLADA 1.5, directly in <asset> elsewhere.
    const pugi::xml_node location = document.child("COLLADA").child("asset").find_node(
        [](const pugi::xml_node& node) { return std::string_view(node.name()) == "geographic_location"; });
    if (!location) {
        return {};
    }
    const auto longitude = number_of(location.child_value("longitude"));
    const auto latitude = number_of(location.child_value("latitude"));
    const pugi::xml_node altitude = location.child("altitude");
    const auto height = altitude ? number_of(altitude.child_value()) : 0.0;
    if (!longitude || !latitude || !height) {
        return {std::nullopt, "lacks a numeric latitude or longitude"};
    }
    if (std::abs(*latitude) > kMaxLatitude || std::abs(*longitude) > kMaxLongitude) {
        return {std::nullopt, "is out of range: latitude is at most 90 degrees, longitude at most 180"};
    }
    return {GeographicPlace{*latitude, *longitude, *height, Eigen::Vector3d::Zero()}, ""};
}

}  // namespace

ColladaFacts read_collada_facts(std::span<const std::uint8_t> xml) {
    pugi::xml_document document;
    const auto end = std::ranges::find(xml, std::uint8_t{0});  // where assimp stops reading
    if (!document.load_buffer(xml.data(), static_cast<std::size_t>(end - xml.begin()))) {
        return {};  // the importer reports it
    }
    return {collada_fault(document), geography_of(document)};
}

void trim_element_starts(std::vector<std::uint8_t>& xml) {
    const auto is_space = [](std::uint8_t c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    std::size_t size = 0;
    for (std::size_t i = 0; i < xml.size(); ++i) {
        xml[size++] = xml[i];
        if (xml[i] == '>') {
            while (i + 1 < xml.size() && is_space(xml[i + 1])) {
                ++i;
            }
        }
    }
    xml.resize(size);
}

}  // namespace campuswalk::scene
