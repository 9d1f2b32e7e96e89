#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/export/mesh_groups.h"

namespace campuswalk::scene {

/// The arrays of a GLB: those of all groups one after another in a few buffer views, each compressed as a
/// whole (EXT_meshopt_compression), and images as they are.
class GlbBuffers {
public:
    enum class View { positions_16, positions_float, normals, uvs, colors, indices_16, indices_32 };
    static constexpr std::size_t kViews = 7;

    /// Appends elements of the view's layout and returns their offset in it, bytes.
    std::size_t append(View view, std::string_view elements);
    /// Appends an image and returns its number.
    std::size_t append_image(std::string bytes);

    struct Finished {
        std::string bin;                             ///< the binary chunk
        std::string json;                            ///< the members "buffers" and "bufferViews"
        std::array<std::size_t, kViews> views = {};  ///< the buffer view of each that isn't empty
        std::size_t first_image = 0;                 ///< the buffer view of image 0; the others follow
    };
    /// Compresses everything.
    Finished finish();

private:
    std::array<std::string, kViews> raw_;
    std::vector<std::string> images_;
};

}  // namespace campuswalk::scene
