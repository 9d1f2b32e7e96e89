#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "scene/import/gltf/buffers.h"
#include "scene/import/gltf/document.h"

namespace campuswalk::scene::gltf {

/// Reads accessors into plain arrays: any component type, normalized or not, interleaved, sparse, or without
/// data (zeros). Throws GltfError if one exceeds its buffer view or has an invalid type.
class Accessors {
public:
    Accessors(const Document& document, Buffers& buffers) : document_(document), buffers_(buffers) {}

    std::size_t count(std::size_t index) const;
    /// `components` floats per element.
    std::vector<float> floats(std::size_t index, int components);
    std::vector<Eigen::Matrix4d> matrices(std::size_t index);
    std::vector<Eigen::Vector3f> vectors3(std::size_t index);
    std::vector<Eigen::Vector4f> vectors4(std::size_t index);
    std::vector<Eigen::Vector2f> vectors2(std::size_t index);
    std::vector<std::array<std::uint8_t, 4>> colors(std::size_t index);  ///< of RGB or RGBA
    std::vector<std::uint32_t> indices(std::size_t index);

    /// The number of accessors read so far that have no data.
    std::size_t without_data() const { return without_data_; }

private:
    struct Layout;
    Layout layout_of(const JsonObject& item) const;
    template <int kComponents>
    std::vector<Eigen::Matrix<float, kComponents, 1>> vectors(std::size_t index);
    template <typename T>
    void read(const JsonObject& item, const Layout& layout, std::span<T> out);
    template <typename T>
    void read_sparse(const JsonObject& sparse, const Layout& layout, std::span<T> out);

    const Document& document_;
    Buffers& buffers_;
    std::size_t without_data_ = 0;
};

}  // namespace campuswalk::scene::gltf
