#pragma once

#include <cstdint>
#include <span>

#include "engine/render/geometry/campus_geometry.h"
#include "engine/render/gl/gl_functions.h"

namespace campuswalk::engine::render {

/// Vertices and indices in the driver's memory, as long as its context lives.
class GpuMesh {
public:
    explicit GpuMesh(const GlFunctions& gl);

    void upload_vertices(std::span<const Vertex> vertices) const;
    void upload_indices(std::span<const std::uint32_t> indices) const;
    /// Before the first, one that leaves the vertices where they are is there.
    void upload_instances(std::span<const Instance> instances) const;
    /// Triangles of `count` indices from `first` on. The mesh must be bound.
    void draw(std::size_t first, std::size_t count) const;
    /// Likewise a batch, all its instances.
    void draw(const Batch& batch) const;
    void bind() const;
    /// A second list of indices over this mesh's vertices.
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
