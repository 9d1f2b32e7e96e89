#include "scene/import/source/collada_fault.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

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

    /// Of a name with a leading '#'. Those that don't exist are for assimp to report.
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

}  // namespace

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

}  // namespace campuswalk::scene
