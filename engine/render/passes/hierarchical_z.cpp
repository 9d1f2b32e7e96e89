#include "engine/render/passes/hierarchical_z.h"

#include "engine/render/passes/shaders.h"

namespace campuswalk::engine::render {
namespace {

constexpr std::string_view kDefineMultisampled = "#define MULTISAMPLED\n";

// The farthest depth (the smallest, as depth is reversed) over a tile's pixels and all their samples.
constexpr std::string_view kFarthestFragment = R"(
#if defined(MULTISAMPLED)
uniform sampler2DMS depth_map;
#else
uniform sampler2D depth_map;
#endif
uniform ivec2 tile;  // pixels
uniform ivec2 last;  // pixel
out vec4 fragment;

float farthest_at(ivec2 pixel) {
#if defined(MULTISAMPLED)
    return min(min(texelFetch(depth_map, pixel, 0).r, texelFetch(depth_map, pixel, 1).r),
               min(texelFetch(depth_map, pixel, 2).r, texelFetch(depth_map, pixel, 3).r));
#else
    return texelFetch(depth_map, pixel, 0).r;
#endif
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * tile;
    float farthest = 1.0;
    for (int y = 0; y < tile.y; ++y) {
        for (int x = 0; x < tile.x; ++x) {
            farthest = min(farthest, farthest_at(min(first + ivec2(x, y), last)));
        }
    }
    fragment = vec4(farthest);
}
)";

// A readback stalls the pipeline for a millisecond or two. The first comes once the nearby ground and walls,
// which occlude most, have been drawn; the interval then doubles.
constexpr std::size_t kFirstReadback = std::size_t{3} * 15000;  // indices

}  // namespace

HierarchicalZ::HierarchicalZ(const GlFunctions& gl, int samples)
    : gl_(gl),
      farthest_(
          gl, "farthest depth", {shaders::kVersion, shaders::kScreenChunk, shaders::kScreenVertex},
          {shaders::kVersion, samples > 1 ? kDefineMultisampled : std::string_view(), kFarthestFragment}) {
    gl.GenVertexArrays(1, &no_vertices_);
}

HierarchicalZ::~HierarchicalZ() {
    delete_tiles();
}

void HierarchicalZ::delete_tiles() {
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteTextures(1, &texture_);
}

void HierarchicalZ::fit(int width, int height) {
    if (width == image_width_ && height == image_height_) {
        return;
    }
    delete_tiles();
    image_width_ = width;
    image_height_ = height;
    columns_ = (width + DepthTiles::kTileWidth - 1) / DepthTiles::kTileWidth;
    rows_ = (height + DepthTiles::kTileHeight - 1) / DepthTiles::kTileHeight;
    gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, columns_, rows_, 0, GL_RED, GL_FLOAT, nullptr);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
}

void HierarchicalZ::begin(const RenderTarget& target, const Eigen::Matrix4d& clip_campus) {
    fit(target.width(), target.height());
    target.resume();
    target_ = &target;
    clip_campus_ = clip_campus;
    tiles_.farthest.clear();
    drawn_ = 0;
    next_readback_ = kFirstReadback;
}

bool HierarchicalZ::occludes(const Eigen::AlignedBox3d& box) const {
    return !tiles_.empty() && tiles_.occlude(box, clip_campus_, target_->width(), target_->height());
}

bool HierarchicalZ::count_drawn(std::size_t indices) {
    drawn_ += indices;
    if (drawn_ < next_readback_) {
        return false;
    }
    read_back();
    drawn_ = 0;
    next_readback_ *= 2;
    return true;
}

void HierarchicalZ::read_back() {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, columns_, rows_);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_CULL_FACE);
    gl_.ActiveTexture(GL_TEXTURE0);
    target_->bind_depth();
    farthest_.use();
    farthest_.set("depth_map", 0);
    farthest_.set("tile", Eigen::Vector2i(DepthTiles::kTileWidth, DepthTiles::kTileHeight));
    farthest_.set("last", Eigen::Vector2i(target_->width() - 1, target_->height() - 1));
    gl_.BindVertexArray(no_vertices_);
    gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    tiles_.columns = columns_;
    tiles_.rows = rows_;
    tiles_.farthest.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_.ReadPixels(0, 0, columns_, rows_, GL_RED, GL_FLOAT, tiles_.farthest.data());
    gl_.Enable(GL_DEPTH_TEST);
    target_->resume();
}

}  // namespace campuswalk::engine::render
