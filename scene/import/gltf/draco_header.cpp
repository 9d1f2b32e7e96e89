#include "scene/import/gltf/draco_header.h"

#include <cstddef>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wpedantic"
#endif
#include <draco/compression/config/compression_shared.h>
#include <draco/core/decoder_buffer.h>
#include <draco/core/varint_decoding.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "scene/model/model_limits.h"

namespace campuswalk::scene::gltf {
namespace {

constexpr std::uint32_t kAlwaysAllowed = 10'000;  // triangles or vertices

/// Of the flattest meshes: a level grid of two million triangles takes 40 a byte, one whose vertices all
/// coincide 1,100.
constexpr std::uint64_t kMostPerByte = 1'000;

/// Of an attribute's decoder, and of the attribute itself.
constexpr std::size_t kMinAttributeBytes = 10;

struct Ended : std::exception {};

struct Announced {
    std::uint64_t triangles = 0;
    std::uint64_t vertices = 0;
    std::size_t seamed_attributes = 0;  ///< each gets a table of all corners
    std::size_t bytes_left = 0;         ///< behind these numbers
};

/// Of the bitstream; counts of older ones have four bytes.
enum class Version : int {
    with_metadata = DRACO_BITSTREAM_VERSION(1, 3),
    short_edgebreaker_counts = DRACO_BITSTREAM_VERSION(2, 0),
    short_sequential_counts = DRACO_BITSTREAM_VERSION(2, 2),
    without_new_vertices = DRACO_BITSTREAM_VERSION(2, 2)
};

/// Reads what precedes a mesh's data. Throws Ended where the bytes end.
class HeaderReader {
public:
    explicit HeaderReader(Bytes packed) {
        buffer_.Init(reinterpret_cast<const char*>(packed.data()), packed.size());
    }

    Announced read() {
        skip(5);  // the magic bytes
        const auto major = take<std::uint8_t>();
        version_ = DRACO_BITSTREAM_VERSION(major, take<std::uint8_t>());
        const bool is_mesh = take<std::uint8_t>() == draco::TRIANGULAR_MESH;
        const auto method = take<std::uint8_t>();
        const bool has_metadata = (take<std::uint16_t>() & METADATA_FLAG_MASK) != 0;
        if (!is_mesh) {
            return {};
        }
        if (has_metadata && is_since(Version::with_metadata)) {
            skip_metadata();
        }
        Announced announced;
        if (method == draco::MESH_SEQUENTIAL_ENCODING) {
            announced.triangles = take_count(Version::short_sequential_counts);
            announced.vertices = take_count(Version::short_sequential_counts);
        } else {
            skip(1);  // the kind of traversal
            if (!is_since(Version::without_new_vertices)) {
                take_count(Version::short_edgebreaker_counts);
            }
            announced.vertices = take_count(Version::short_edgebreaker_counts);
            announced.triangles = take_count(Version::short_edgebreaker_counts);
            announced.seamed_attributes = take<std::uint8_t>();
        }
        announced.bytes_left = left();
        return announced;
    }

private:
    bool is_since(Version version) const { return version_ >= static_cast<int>(version); }

    std::size_t left() const { return static_cast<std::size_t>(buffer_.remaining_size()); }

    template <typename Number>
    Number take() {
        Number number = 0;
        if (!buffer_.Decode(&number)) {
            throw Ended();
        }
        return number;
    }

    std::uint32_t take_varint() {
        std::uint32_t number = 0;
        if (!draco::DecodeVarint(&number, &buffer_)) {
            throw Ended();
        }
        return number;
    }

    std::uint32_t take_count(Version shortened) {
        return is_since(shortened) ? take_varint() : take<std::uint32_t>();
    }

    void skip(std::size_t bytes) {
        if (bytes > left()) {
            throw Ended();
        }
        buffer_.Advance(static_cast<std::int64_t>(bytes));
    }

    /// Trees of named values: each attribute's, then the mesh's.
    void skip_metadata() {
        for (std::uint32_t attributes = take_varint(); attributes > 0; --attributes) {
            take_varint();  // its id
            skip_tree();
        }
        skip_tree();
    }

    /// Draco notes each announced tree before it reads one, so all that are outstanding must fit into the
    /// bytes.
    void skip_tree() {
        skip_values();
        std::size_t outstanding = take_varint();
        while (outstanding > 0) {
            if (outstanding > left()) {
                throw Ended();
            }
            skip(take<std::uint8_t>());  // its name
            skip_values();
            outstanding += take_varint() - std::size_t{1};
        }
    }

    void skip_values() {
        for (std::uint32_t values = take_varint(); values > 0; --values) {
            skip(take<std::uint8_t>());  // its name
            skip(take_varint());
        }
    }

    draco::DecoderBuffer buffer_;
    int version_ = 0;
};

}  // namespace

std::string why_draco_too_large(Bytes packed) {
    Announced announced;
    try {
        announced = HeaderReader(packed).read();
    } catch (const Ended&) {
        return "ends before its data begins";
    }
    const auto announces = [&](std::uint64_t count, const char* what) {
        return "announces " + std::to_string(count) + " " + what;
    };
    if (announced.triangles > kMaxTriangles) {
        return announces(announced.triangles, "triangles; a model may have ") + std::to_string(kMaxTriangles);
    }
    const std::uint64_t most = kAlwaysAllowed + kMostPerByte * announced.bytes_left;
    const std::string bytes = ", more than " + std::to_string(announced.bytes_left) + " bytes can hold";
    if (announced.triangles > most) {
        return announces(announced.triangles, "triangles") + bytes;
    }
    if (announced.vertices > most) {
        return announces(announced.vertices, "vertices") + bytes;
    }
    if (announced.seamed_attributes > announced.bytes_left / kMinAttributeBytes) {
        return announces(announced.seamed_attributes, "attributes") + bytes;
    }
    return "";
}

}  // namespace campuswalk::scene::gltf
