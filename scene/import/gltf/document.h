#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "scene/import/gltf/container.h"

namespace campuswalk::scene::gltf {

/// A JSON object and its path for messages (`accessors/3`). Reading a key checks its type and throws
/// GltfError; other keys are not validated.
class JsonObject {
public:
    JsonObject(const nlohmann::json& object, std::string path);

    bool has(const char* key) const;
    std::optional<JsonObject> object(const char* key) const;
    std::vector<JsonObject> objects(const char* key) const;  ///< empty if absent
    std::string string(const char* key) const;               ///< empty if absent
    bool boolean(const char* key) const;                     ///< false if absent
    std::optional<std::size_t> uint(const char* key) const;
    std::size_t required_uint(const char* key) const;
    double number(const char* key, double otherwise) const;
    /// An array of exactly `count` numbers, nullopt if absent. Single precision is what glTF requires.
    std::optional<std::vector<float>> floats(const char* key, std::size_t count) const;
    std::optional<std::vector<double>> doubles(const char* key, std::size_t count) const;
    std::vector<float> all_floats(const char* key) const;  ///< of an array of any length; empty if absent
    std::vector<std::size_t> uints(const char* key) const;
    std::vector<std::string> strings(const char* key) const;
    std::vector<std::string> keys() const;

    [[noreturn]] void fail(const std::string& what) const;

private:
    const nlohmann::json* find(const char* key) const;

    const nlohmann::json* object_;
    std::string path_;
};

/// The parsed JSON.
class Document {
public:
    explicit Document(Bytes json);  ///< throws GltfError with the position of a syntax error
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    JsonObject root() const;
    std::size_t size(const char* array) const;
    /// Element `index` of a top-level array; throws GltfError if it doesn't exist.
    JsonObject item(const char* array, std::size_t index) const;

private:
    std::unique_ptr<nlohmann::json> json_;
};

}  // namespace campuswalk::scene::gltf
