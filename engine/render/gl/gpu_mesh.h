#pragma once

#include <cstdint>
#include <span>

#include "engine/render/geometry/campus_geometry.h"
#include "engine/render/gl/gl_functions.h"

namespace campuswalk::engine::render {

/// A vertex array with its buffers in GPU memory. Must not outlive its context.
class GpuMesh {
public:
    explicit GpuMesh(const GlFunctions& gl);

    void upload_vertices(std::span<const Vertex> vertices) const;
    void upload_indices(std::span<const std::uint32_t> indices) const;
    /// Initially there is one identity instance.
    void upload_instances(std::span<const Instance> instances) const;
    /// Draws `count` indices from `first` as triangles. The mesh must be bound.
    void draw(std::size_t first, std::size_t count) const;
    /// Draws all instances of a batch. The mesh must be bound.
    void draw(const Batch& batch) const;
    void bind() const;
    /// Another mesh with its own indices over this mesh's vertices.
    GpuMesh sharing_vertices() const;

private:
    GpuMesh(const GlFunctions& gl, GLuint vertices);
    void describe_vertices() const;
    void describe_instances() const;

    const GlFunctions& gl_;
    GLuint array_ = 0;
    GLuint vertices_ = 0;
    GLuint indices_ = 0;
    GLuint instances_ = 0;
};

}  // namespace campuswalk::engine::render
