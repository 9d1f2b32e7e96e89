#include "scene/import/gltf/document.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <nlohmann/json.hpp>

namespace campuswalk::scene::gltf {
namespace {

using Json = nlohmann::json;

/// A non-negative integer; `2.0` is one too.
std::optional<std::size_t> to_uint(const Json& value) {
    if (value.is_number_unsigned()) {
        return value.get<std::size_t>();
    }
    constexpr double kExact = 9007199254740992.0;  // 2^53
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (number >= 0.0 && number < kExact && std::floor(number) == number) {
            return static_cast<std::size_t>(number);
        }
    }
    return std::nullopt;
}

}  // namespace

JsonObject::JsonObject(const Json& object, std::string path) : object_(&object), path_(std::move(path)) {
    if (!object.is_object()) {
        fail("must be an object");
    }
}

void JsonObject::fail(const std::string& what) const {
    throw GltfError((path_.empty() ? "its JSON" : path_) + " " + what);
}

const Json* JsonObject::find(const char* key) const {
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

bool JsonObject::has(const char* key) const {
    return find(key) != nullptr;
}

std::optional<JsonObject> JsonObject::object(const char* key) const {
    const Json* value = find(key);
    return value == nullptr ? std::nullopt
                            : std::optional<JsonObject>(std::in_place, *value, path_ + "/" + key);
}

std::vector<JsonObject> JsonObject::objects(const char* key) const {
    std::vector<JsonObject> result;
    if (const Json* value = find(key)) {
        if (!value->is_array()) {
            fail("has '" + std::string(key) + "', which must be an array");
        }
        for (const Json& element : *value) {
            result.emplace_back(element, path_ + "/" + key + "/" + std::to_string(result.size()));
        }
    }
    return result;
}

std::string JsonObject::string(const char* key) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return {};
    }
    if (!value->is_string()) {
        fail("has '" + std::string(key) + "', which must be a string");
    }
    return value->get<std::string>();
}

bool JsonObject::boolean(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_boolean()) {
        fail("has '" + std::string(key) + "', which must be true or false");
    }
    return value != nullptr && value->get<bool>();
}

std::optional<std::size_t> JsonObject::uint(const char* key) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    const auto number = to_uint(*value);
    if (!number) {
        fail("has '" + std::string(key) + "', which must be a non-negative integer");
    }
    return number;
}

std::size_t JsonObject::required_uint(const char* key) const {
    const auto number = uint(key);
    if (!number) {
        fail("lacks '" + std::string(key) + "'");
    }
    return *number;
}

double JsonObject::number(const char* key, double otherwise) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return otherwise;
    }
    if (!value->is_number()) {
        fail("has '" + std::string(key) + "', which must be a number");
    }
    return value->get<double>();
}

std::optional<std::vector<float>> JsonObject::floats(const char* key, std::size_t count) const {
    const auto exact = doubles(key, count);
    if (!exact) {
        return std::nullopt;
    }
    std::vector<float> result;
    for (const double number : *exact) {
        result.push_back(static_cast<float>(number));
    }
    return result;
}

std::optional<std::vector<double>> JsonObject::doubles(const char* key, std::size_t count) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    std::vector<double> result;
    if (value->is_array() && value->size() == count) {
        for (const Json& element : *value) {
            if (element.is_number()) {
                result.push_back(element.get<double>());
            }
        }
    }
    if (result.size() != count) {
        fail("has '" + std::string(key) + "', which must be " + std::to_string(count) + " numbers");
    }
    return result;
}

std::vector<float> JsonObject::all_floats(const char* key) const {
    const Json* value = find(key);
    return value == nullptr ? std::vector<float>{} : *floats(key, value->is_array() ? value->size() : 0);
}

std::vector<std::size_t> JsonObject::uints(const char* key) const {
    std::vector<std::size_t> result;
    if (const Json* value = find(key)) {
        for (const Json& element : *value) {
            const auto number = value->is_array() ? to_uint(element) : std::nullopt;
            if (!number) {
                fail("has '" + std::string(key) + "', which must be an array of non-negative integers");
            }
            result.push_back(*number);
        }
    }
    return result;
}

std::vector<std::string> JsonObject::strings(const char* key) const {
    std::vector<std::string> result;
    if (const Json* value = find(key)) {
        for (const Json& element : *value) {
            if (!value->is_array() || !element.is_string()) {
                fail("has '" + std::string(key) + "', which must be an array of strings");
            }
            result.push_back(element.get<std::string>());
        }
    }
    return result;
}

std::vector<std::string> JsonObject::keys() const {
    std::vector<std::string> result;
    for (const auto& element : object_->items()) {
        result.push_back(element.key());
    }
    return result;
}

Document::Document(Bytes json) {
    try {
        json_ = std::make_unique<Json>(Json::parse(json.begin(), json.end()));
    } catch (const Json::parse_error& error) {
        // what() may end in an incomplete UTF-8 sequence.
        throw GltfError("its JSON can't be parsed at byte " + std::to_string(error.byte));
    } catch (const Json::out_of_range& error) {
        const std::string_view words = error.what();  // ends in the number, in quotes
        throw GltfError("its JSON contains a number out of range: " +
                        std::string(words.substr(std::min(words.find('\''), words.size()))));
    }
    root();
}

Document::~Document() = default;

JsonObject Document::root() const {
    return {*json_, ""};
}

std::size_t Document::size(const char* array) const {
    const auto found = json_->find(array);
    if (found == json_->end()) {
        return 0;
    }
    if (!found->is_array()) {
        throw GltfError("'" + std::string(array) + "' must be an array");
    }
    return found->size();
}

JsonObject Document::item(const char* array, std::size_t index) const {
    const std::string path = std::string(array) + "/" + std::to_string(index);
    if (index >= size(array)) {
        throw GltfError(path + " is referenced but does not exist");
    }
    return {(*json_)[array][index], path};
}

}  // namespace campuswalk::scene::gltf
