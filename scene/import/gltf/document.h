#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "scene/import/gltf/container.h"

namespace campuswalk::scene::gltf {

/// An object of the JSON text, with its place in it for messages (`accessors/3`). Reading a key checks its
/// type and throws Fault; what nobody reads may be anything.
class Item {
public:
    Item(const nlohmann::json& object, std::string place);

    bool has(const char* key) const;
    std::optional<Item> object(const char* key) const;
    std::vector<Item> objects(const char* key) const;  ///< none when the key isn't there
    std::string text(const char* key) const;           ///< empty when it isn't there
    bool flag(const char* key) const;                  ///< false when it isn't there
    std::optional<std::size_t> whole(const char* key) const;
    std::size_t needed_whole(const char* key) const;
    double number(const char* key, double otherwise) const;
    /// An array of exactly `count` numbers as single precision, which is all that glTF asks for; none when
    /// the key isn't there.
    std::optional<std::vector<float>> numbers(const char* key, std::size_t count) const;
    /// Likewise as they are written.
    std::optional<std::vector<double>> exact_numbers(const char* key, std::size_t count) const;
    std::vector<std::size_t> wholes(const char* key) const;
    std::vector<std::string> texts(const char* key) const;
    std::vector<std::string> keys() const;

    const std::string& place() const { return place_; }
    [[noreturn]] void fail(const std::string& what) const;

private:
    const nlohmann::json* find(const char* key) const;

    const nlohmann::json* object_;
    std::string place_;
};

/// The JSON text, parsed.
class Document {
public:
    explicit Document(Bytes json);  ///< throws Fault with line and column of a syntax error
    ~Document();
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    Item root() const;
    std::size_t size(const char* array) const;
    /// Element `index` of one of the top arrays; throws Fault when there is none.
    Item item(const char* array, std::size_t index) const;

private:
    std::unique_ptr<nlohmann::json> json_;
};

}  // namespace campuswalk::scene::gltf
