#include "scene/import/gltf/document.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scene/import/gltf/fault.h"

namespace campuswalk::scene::gltf {
namespace {

using Json = nlohmann::json;

/// A JSON number that is a whole one from 0 on; `2.0` is one too.
std::optional<std::size_t> to_whole(const Json& value) {
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

Item::Item(const Json& object, std::string place) : object_(&object), place_(std::move(place)) {
    if (!object.is_object()) {
        fail("must be an object");
    }
}

void Item::fail(const std::string& what) const {
    throw Fault((place_.empty() ? "its JSON" : place_) + " " + what);
}

const Json* Item::find(const char* key) const {
    const auto found = object_->find(key);
    return found == object_->end() ? nullptr : &*found;
}

bool Item::has(const char* key) const {
    return find(key) != nullptr;
}

std::optional<Item> Item::object(const char* key) const {
    const Json* value = find(key);
    return value == nullptr ? std::nullopt : std::optional<Item>(std::in_place, *value, place_ + "/" + key);
}

std::vector<Item> Item::objects(const char* key) const {
    std::vector<Item> result;
    if (const Json* value = find(key)) {
        if (!value->is_array()) {
            fail("has '" + std::string(key) + "', which must be an array");
        }
        for (const Json& element : *value) {
            result.emplace_back(element, place_ + "/" + key + "/" + std::to_string(result.size()));
        }
    }
    return result;
}

std::string Item::text(const char* key) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return {};
    }
    if (!value->is_string()) {
        fail("has '" + std::string(key) + "', which must be a string");
    }
    return value->get<std::string>();
}

bool Item::flag(const char* key) const {
    const Json* value = find(key);
    if (value != nullptr && !value->is_boolean()) {
        fail("has '" + std::string(key) + "', which must be true or false");
    }
    return value != nullptr && value->get<bool>();
}

std::optional<std::size_t> Item::whole(const char* key) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return std::nullopt;
    }
    const auto number = to_whole(*value);
    if (!number) {
        fail("has '" + std::string(key) + "', which must be a non-negative integer");
    }
    return number;
}

std::size_t Item::needed_whole(const char* key) const {
    const auto number = whole(key);
    if (!number) {
        fail("lacks '" + std::string(key) + "'");
    }
    return *number;
}

double Item::number(const char* key, double otherwise) const {
    const Json* value = find(key);
    if (value == nullptr) {
        return otherwise;
    }
    if (!value->is_number()) {
        fail("has '" + std::string(key) + "', which must be a number");
    }
    return value->get<double>();
}

std::optional<std::vector<float>> Item::numbers(const char* key, std::size_t count) const {
    const auto exact = exact_numbers(key, count);
    if (!exact) {
        return std::nullopt;
    }
    std::vector<float> result;
    for (const double number : *exact) {
        result.push_back(static_cast<float>(number));
    }
    return result;
}

std::optional<std::vector<double>> Item::exact_numbers(const char* key, std::size_t count) const {
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

std::vector<std::size_t> Item::wholes(const char* key) const {
    std::vector<std::size_t> result;
    if (const Json* value = find(key)) {
        for (const Json& element : *value) {
            const auto number = value->is_array() ? to_whole(element) : std::nullopt;
            if (!number) {
                fail("has '" + std::string(key) + "', which must be an array of non-negative integers");
            }
            result.push_back(*number);
        }
    }
    return result;
}

std::vector<std::string> Item::texts(const char* key) const {
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

std::vector<std::string> Item::keys() const {
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
        // Its words end in what it read last, perhaps half a character: the place is enough.
        throw Fault("its JSON can't be parsed at byte " + std::to_string(error.byte));
    } catch (const Json::out_of_range& error) {
        const std::string_view words = error.what();  // they end in the number, in quotes
        throw Fault("its JSON contains a number out of range: " +
                    std::string(words.substr(std::min(words.find('\''), words.size()))));
    }
    root();
}

Document::~Document() = default;

Item Document::root() const {
    return {*json_, ""};
}

std::size_t Document::size(const char* array) const {
    const auto found = json_->find(array);
    if (found == json_->end()) {
        return 0;
    }
    if (!found->is_array()) {
        throw Fault("'" + std::string(array) + "' must be an array");
    }
    return found->size();
}

Item Document::item(const char* array, std::size_t index) const {
    const std::string place = std::string(array) + "/" + std::to_string(index);
    if (index >= size(array)) {
        throw Fault(place + " is referenced but does not exist");
    }
    return {(*json_)[array][index], place};
}

}  // namespace campuswalk::scene::gltf
