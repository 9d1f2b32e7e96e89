#include "scene/import/source/collada_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <pugixml.hpp>
#include <string_view>

namespace campuswalk::scene {

namespace {

bool is_one_of(std::string_view name, std::span<const std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

constexpr std::array<std::string_view, 7> kPrimitives = {"lines",     "linestrips", "polygons", "polylist",
                                                         "triangles", "trifans",    "tristrips"};
constexpr std::array<std::string_view, 3> kArrays = {"float_array", "IDREF_array", "Name_array"};

/// What inputs of meshes may refer to. Ids need not be unique: all that share one are checked.
class ColladaData final : public pugi::xml_tree_walker {
public:
    bool for_each(pugi::xml_node& node) override {
        const std::string_view name = node.name();
        if (is_one_of(name, kArrays)) {
            const std::uint64_t count = name == "float_array" ? node.attribute("count").as_uint() : 0;
            const auto [known, is_new] = array_sizes_.emplace(node.attribute("id").value(), count);
            known->second = is_new ? count : std::min(known->second, count);
        } else if (name == "accessor") {
            pugi::xml_node source = node.parent();
            while (source && std::string_view(source.name()) != "source") {
                source = source.parent();
            }
            accessors_[source.attribute("id").value()].push_back(node);
        } else if (name == "mesh") {
            meshes_.push_back(node);
        }
        return true;
    }

    const std::vector<pugi::xml_node>& meshes() const { return meshes_; }

    /// `source` is a name with a leading '#'. Names that don't exist are for assimp to report.
    bool is_in_range(std::string_view source) const {
        const auto found = accessors_.find(source.substr(std::min<std::size_t>(source.size(), 1)));
        return found == accessors_.end() ||
               std::ranges::all_of(found->second,
                                   [this](const pugi::xml_node& accessor) { return fits(accessor); });
    }

private:
    bool fits(const pugi::xml_node& accessor) const {
        const std::string_view array = accessor.attribute("source").value();
        const auto size = array_sizes_.find(array.substr(std::min<std::size_t>(array.size(), 1)));
        const int count = accessor.attribute("count").as_int();
        if (size == array_sizes_.end() || count == 0) {
            return true;
        }
        const std::uint64_t offset = accessor.attribute("offset").as_uint();
        const std::uint64_t stride = accessor.attribute("stride").as_uint(1);
        const auto params = accessor.children("param");
        const auto values = static_cast<std::uint64_t>(std::distance(params.begin(), params.end()));
        return count > 0 && offset + (static_cast<std::uint64_t>(count) - 1) * stride +
                                    std::max<std::uint64_t>(values, 1) <=
                                size->second;
    }

    std::map<std::string, std::uint64_t, std::less<>> array_sizes_;
    std::map<std::string, std::vector<pugi::xml_node>, std::less<>> accessors_;
    std::vector<pugi::xml_node> meshes_;
};

bool holds_only_numbers(const pugi::xml_node& node) {
    return std::string_view(node.text().get()).find_first_not_of("0123456789+- \t\r\n") ==
           std::string_view::npos;
}

std::string inputs_fault(const pugi::xml_node& parent, const ColladaData& data) {
    for (const pugi::xml_node& input : parent.children("input")) {
        const char* source = input.attribute("source").value();
        if (std::string_view(input.attribute("semantic").value()) != "VERTEX" && !data.is_in_range(source)) {
            return "the accessor of source '" + std::string(source) + "' reaches beyond its array of numbers";
        }
    }
    return "";
}

std::string primitive_fault(const pugi::xml_node& primitive) {
    const std::string kind = "<" + std::string(primitive.name()) + ">";
    bool has_vcount = kind != "<polylist>";
    bool has_vertices = false;
    for (const pugi::xml_node& child : primitive.children()) {
        const std::string_view name = child.name();
        has_vertices = has_vertices ||
                       (name == "input" && std::string_view(child.attribute("semantic").value()) == "VERTEX");
        has_vcount = has_vcount || name == "vcount";
        if (name == "ph") {
            return "a " + kind +
                   " has holes (<ph>), which aren't read: have the exporter triangulate all faces";
        }
        if ((name == "p" || name == "vcount") && !holds_only_numbers(child)) {
            return "the <" + std::string(name) + "> of a " + kind +
                   " holds something else than whole numbers";
        }
        if (name == "p" && !has_vertices) {
            return "a " + kind + " lacks an input with the semantic VERTEX";
        }
        if (name == "p" && !has_vcount) {
            return "a " + kind + " lacks <vcount>";
        }
    }
    return "";
}

/// What is wrong with the numbers of a COLLADA file's meshes; empty if nothing is. assimp 5.2.5 reads beyond
/// arrays that are shorter than their accessors say, and never gets past a word among indices.
std::string collada_fault(pugi::xml_document& document) {
    ColladaData data;
    document.traverse(data);
    for (const pugi::xml_node& mesh : data.meshes()) {
        std::string fault = inputs_fault(mesh.child("vertices"), data);
        for (const pugi::xml_node& child : mesh.children()) {
            if (fault.empty() && is_one_of(child.name(), kPrimitives)) {
                fault = inputs_fault(child, data);
                fault = fault.empty() ? primitive_fault(child) : fault;
            }
        }
        if (!fault.empty()) {
            return fault;
        }
    }
    return "";
}

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
