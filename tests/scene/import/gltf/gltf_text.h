#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/temporary_folder.h"

namespace campuswalk::scene::test {

using Json = nlohmann::json;

/// Builds a glTF file: change `json` as needed, then write it.
class GltfText {
public:
    GltfText();

    /// Appends bytes to the only buffer. Returns the index of their view.
    std::size_t add_view(std::span<const std::uint8_t> bytes);
    template <typename T>
    std::size_t add_view(const std::vector<T>& values) {
        return add_view(
            std::span(reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)));
    }
    std::size_t add_accessor(std::size_t view, int component, std::size_t count, const char* type);
    std::size_t add_floats(const std::vector<float>& values, const char* type);
    /// Adds a mesh of one primitive, without a node.
    std::size_t add_mesh(Json primitive);
    /// Adds a right triangle with legs of 1 m in the plane y = 0, facing up: its positions, or a mesh of it.
    std::size_t add_triangle_positions();
    std::size_t add_triangle_mesh() {
        return add_mesh({{"attributes", {{"POSITION", add_triangle_positions()}}}});
    }
    /// Adds a node to the scene.
    std::size_t add_node(Json node);

    void write_gltf(const support::TemporaryFolder& folder, const std::string& name) const;
    void write_glb(const support::TemporaryFolder& folder, const std::string& name) const;

    std::size_t buffer_bytes() const { return buffer_.size(); }

    Json json;

private:
    std::string buffer_;
};

}  // namespace campuswalk::scene::test
