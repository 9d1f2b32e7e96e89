#include "scene/import/gltf/buffers.h"

#include <string_view>

#include "scene/import/gltf/meshopt.h"

namespace campuswalk::scene::gltf {
namespace {

/// The value of a base64 character (RFC 4648); -1 for others.
int base64_value(char c) {
    if (c >= 'A' && c <= 'Z') {
        return c - 'A';
    }
    if (c >= 'a' && c <= 'z') {
        return c - 'a' + 26;
    }
    if (c >= '0' && c <= '9') {
        return c - '0' + 52;
    }
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Padding is optional. nullopt if a character is not in the alphabet.
std::optional<std::vector<std::uint8_t>> decode_base64(std::string_view text) {
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding) {
        text.remove_suffix(1);
    }
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t bits = 0;
    unsigned int count = 0;
    for (const char c : text) {
        const int value = base64_value(c);
        if (value < 0) {
            return std::nullopt;
        }
        bits = bits << 6U | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::uint8_t>(bits >> count));
        }
    }
    return bytes;
}

}  // namespace

std::optional<std::vector<std::uint8_t>> Buffers::data_of_uri(const std::string& uri) {
    if (!uri.starts_with("data:")) {
        return std::nullopt;
    }
    constexpr std::string_view kBase64 = ";base64,";
    const std::size_t at = uri.find(kBase64);
    auto bytes = at == std::string::npos ? std::nullopt
                                         : decode_base64(std::string_view(uri).substr(at + kBase64.size()));
    if (!bytes) {
        throw GltfError("a data URI is not valid base64; re-export the file");
    }
    return bytes;
}

std::vector<std::uint8_t> Buffers::fetch(const JsonObject& buffer, const std::string& uri) const {
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
    const JsonObject item = document_.item("buffers", index);
    const std::size_t length = item.required_uint("byteLength");
    Bytes whole;
    if (item.has("uri")) {
        auto known = fetched_.find(index);
        if (known == fetched_.end()) {
            known = fetched_.emplace(index, fetch(item, item.string("uri"))).first;
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

/// `where` has the byteOffset and byteLength.
Bytes Buffers::slice(std::size_t buffer, const JsonObject& where, Bytes whole) const {
    const std::size_t offset = where.uint("byteOffset").value_or(0);
    const std::size_t length = where.required_uint("byteLength");
    if (offset > whole.size() || length > whole.size() - offset) {
        where.fail("extends past the end of buffers/" + std::to_string(buffer));
    }
    return whole.subspan(offset, length);
}

Bytes Buffers::decoded(std::size_t index, const JsonObject& compression) {
    const auto known = decoded_.find(index);
    if (known != decoded_.end()) {
        return known->second;
    }
    const std::size_t source = compression.required_uint("buffer");
    const auto whole = buffer(source);
    if (!whole) {
        compression.fail("has no data");
    }
    return decoded_.emplace(index, decode_meshopt(compression, slice(source, compression, *whole)))
        .first->second;
}

std::optional<Bytes> Buffers::view(std::size_t index) {
    const JsonObject item = document_.item("bufferViews", index);
    if (const auto extensions = item.object("extensions")) {
        for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
            if (const auto compression = extensions->object(name)) {
                return decoded(index, *compression);
            }
        }
    }
    const std::size_t source = item.required_uint("buffer");
    const auto whole = buffer(source);
    return whole ? std::optional<Bytes>(slice(source, item, *whole)) : std::nullopt;
}

}  // namespace campuswalk::scene::gltf
