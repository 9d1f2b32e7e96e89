#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/import/gltf/document.h"
#include "scene/import/source/scene_folder.h"

namespace campuswalk::scene::gltf {

/// The bytes that a file's buffers and buffer views name, each fetched when it is first asked for: the BIN
/// chunk, data in the text itself, or a file that the scene may read.
class Buffers {
public:
    Buffers(const Document& document, std::optional<Bytes> binary, SceneFolder folder)
        : document_(document), binary_(binary), folder_(std::move(folder)) {}

    /// A buffer view's bytes, unpacked when they are compressed. nullopt when the file has no data for its
    /// buffer, which glTF allows: what is read of it is 0. Throws Fault for whatever doesn't fit.
    std::optional<Bytes> view(std::size_t index);

    /// What a `data:` URI holds; nullopt for any other.
    static std::optional<std::vector<std::uint8_t>> data_of_uri(const std::string& uri);

private:
    std::optional<Bytes> buffer(std::size_t index);
    std::vector<std::uint8_t> fetch(const Item& buffer, const std::string& uri) const;
    Bytes slice(std::size_t buffer, const Item& where, Bytes whole) const;
    Bytes unpacked(std::size_t index, const Item& compression);

    const Document& document_;
    std::optional<Bytes> binary_;
    SceneFolder folder_;
    std::map<std::size_t, std::vector<std::uint8_t>> fetched_;
    std::map<std::size_t, std::vector<std::uint8_t>> unpacked_;
};

}  // namespace campuswalk::scene::gltf
