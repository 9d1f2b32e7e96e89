#include "scene/import/gltf/buffers.h"

#include "scene/import/gltf/base64.h"
#include "scene/import/gltf/fault.h"
#include "scene/import/gltf/meshopt.h"
#include "scene/import/source/confined_files.h"

namespace campuswalk::scene::gltf {

std::optional<std::vector<std::uint8_t>> Buffers::data_of_uri(const std::string& uri) {
    if (!uri.starts_with("data:")) {
        return std::nullopt;
    }
    constexpr std::string_view kBase64 = ";base64,";
    const std::size_t at = uri.find(kBase64);
    auto bytes = at == std::string::npos ? std::nullopt
                                         : decode_base64(std::string_view(uri).substr(at + kBase64.size()));
    if (!bytes) {
        throw Fault("a data URI is not valid base64; re-export the file");
    }
    return bytes;
}

std::vector<std::uint8_t> Buffers::fetch(const Item& buffer, const std::string& uri) const {
    if (auto data = data_of_uri(uri)) {
        return std::move(*data);
    }
    const auto path = folder_.find_file(uri);
    auto bytes = path ? read_bytes(*path) : std::nullopt;
    if (!bytes) {
        buffer.fail("refers to '" + uri + "', which is missing or outside the scene's folder");
    }
    return std::move(*bytes);
}

std::optional<Bytes> Buffers::buffer(std::size_t index) {
    const Item item = document_.item("buffers", index);
    const std::size_t length = item.needed_whole("byteLength");
    Bytes whole;
    if (item.has("uri")) {
        auto known = fetched_.find(index);
        if (known == fetched_.end()) {
            known = fetched_.emplace(index, fetch(item, item.text("uri"))).first;
        }
        whole = known->second;
    } else if (index == 0 && binary_) {
        whole = *binary_;
    } else {
        return std::nullopt;
    }
    if (whole.size() < length) {
        item.fail("has " + std::to_string(whole.size()) + " bytes instead of " + std::to_string(length) +
                  "; re-export or copy it again");
    }
    return whole.first(length);
}

/// The part of a buffer that `where` names by byteOffset and byteLength.
Bytes Buffers::slice(std::size_t buffer, const Item& where, Bytes whole) const {
    const std::size_t offset = where.whole("byteOffset").value_or(0);
    const std::size_t length = where.needed_whole("byteLength");
    if (offset > whole.size() || length > whole.size() - offset) {
        where.fail("extends past the end of buffers/" + std::to_string(buffer));
    }
    return whole.subspan(offset, length);
}

Bytes Buffers::unpacked(std::size_t index, const Item& compression) {
    const auto known = unpacked_.find(index);
    if (known != unpacked_.end()) {
        return known->second;
    }
    const std::size_t source = compression.needed_whole("buffer");
    const auto whole = buffer(source);
    if (!whole) {
        compression.fail("has no data");
    }
    return unpacked_.emplace(index, unpack_meshopt(compression, slice(source, compression, *whole)))
        .first->second;
}

std::optional<Bytes> Buffers::view(std::size_t index) {
    const Item item = document_.item("bufferViews", index);
    if (const auto extensions = item.object("extensions")) {
        for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
            if (const auto compression = extensions->object(name)) {
                return unpacked(index, *compression);
            }
        }
    }
    const std::size_t source = item.needed_whole("buffer");
    const auto whole = buffer(source);
    return whole ? std::optional<Bytes>(slice(source, item, *whole)) : std::nullopt;
}

}  // namespace campuswalk::scene::gltf
