#include "engine/render/gl/gpu_mesh.h"

#include <cstddef>

namespace campuswalk::engine::render {
namespace {

GLuint make_buffer(const GlFunctions& gl) {
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    return buffer;
}

}  // namespace

GpuMesh::GpuMesh(const GlFunctions& gl) : GpuMesh(gl, make_buffer(gl)) {}

GpuMesh::GpuMesh(const GlFunctions& gl, GLuint vertices)
    : gl_(gl), vertices_(vertices), indices_(make_buffer(gl)), instances_(make_buffer(gl)) {
    gl.GenVertexArrays(1, &array_);
    bind();
    describe_vertices();
    describe_instances();
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
}

void GpuMesh::describe_vertices() const {
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
    constexpr GLsizei stride = sizeof(Vertex);
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, buffer_offset(offsetof(Vertex, position)));
    gl_.VertexAttribPointer(1, 3, GL_SHORT, GL_TRUE, stride, buffer_offset(offsetof(Vertex, normal)));
    gl_.VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, buffer_offset(offsetof(Vertex, uv)));
    gl_.VertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, buffer_offset(offsetof(Vertex, color)));
    for (GLuint i = 0; i < 4; ++i) {
        gl_.EnableVertexAttribArray(i);
    }
}

void GpuMesh::describe_instances() const {
    const Instance identity;
    upload_instances(std::span(&identity, 1));
    constexpr GLsizei stride = sizeof(Instance);
    for (GLuint row = 0; row < 3; ++row) {
        gl_.VertexAttribPointer(4 + row, 4, GL_FLOAT, GL_FALSE, stride,
                                buffer_offset(offsetof(Instance, rows) + row * sizeof(identity.rows[row])));
    }
    gl_.VertexAttribIPointer(7, 1, GL_UNSIGNED_INT, stride, buffer_offset(offsetof(Instance, node)));
    for (GLuint i = 4; i < 8; ++i) {
        gl_.VertexAttribDivisor(i, 1);
        gl_.EnableVertexAttribArray(i);
    }
}

void GpuMesh::upload_instances(std::span<const Instance> instances) const {
    gl_.BindBuffer(GL_ARRAY_BUFFER, instances_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                   GL_STATIC_DRAW);
}

void GpuMesh::upload_vertices(std::span<const Vertex> vertices) const {
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data(),
                   GL_STATIC_DRAW);
}

void GpuMesh::upload_indices(std::span<const std::uint32_t> indices) const {
    bind();
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                   GL_STATIC_DRAW);
}

void GpuMesh::draw(std::size_t first, std::size_t count) const {
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                     buffer_offset(first * sizeof(std::uint32_t)));
}

void GpuMesh::draw(const Batch& batch) const {
    gl_.DrawElementsInstancedBaseInstance(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_INT,
                                          buffer_offset(batch.first * sizeof(std::uint32_t)),
                                          static_cast<GLsizei>(batch.instances),
                                          static_cast<GLuint>(batch.first_instance));
}

void GpuMesh::bind() const {
    gl_.BindVertexArray(array_);
}

GpuMesh GpuMesh::sharing_vertices() const {
    return GpuMesh(gl_, vertices_);
}

}  // namespace campuswalk::engine::render
