#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/import/gltf/document.h"
#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene::gltf {

/// Access to buffers and buffer views, loaded on first use: the BIN chunk, a data URI, or a file that the
/// scene may read.
class Buffers {
public:
    Buffers(const Document& document, std::optional<Bytes> binary, SceneFolder folder)
        : document_(document), binary_(binary), folder_(std::move(folder)) {}

    /// A buffer view's bytes, decompressed. nullopt if its buffer has no data, which glTF allows: it then
    /// reads as zeros. Throws GltfError if it is inconsistent.
    std::optional<Bytes> view(std::size_t index);

    /// The contents of a `data:` URI; nullopt for others.
    static std::optional<std::vector<std::uint8_t>> data_of_uri(const std::string& uri);

private:
    std::optional<Bytes> buffer(std::size_t index);
    std::vector<std::uint8_t> fetch(const JsonObject& buffer, const std::string& uri) const;
    Bytes slice(std::size_t buffer, const JsonObject& where, Bytes whole) const;
    Bytes decoded(std::size_t index, const JsonObject& compression);

    const Document& document_;
    std::optional<Bytes> binary_;
    SceneFolder folder_;
    std::map<std::size_t, std::vector<std::uint8_t>> fetched_;
    std::map<std::size_t, std::vector<std::uint8_t>> decoded_;
};

}  // namespace campuswalk::scene::gltf
