#include "tests/scene/model_files.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

#include <Eigen/Geometry>

namespace campuswalk::scene::test {
namespace {

namespace fs = std::filesystem;

// The vertices of each face, counter-clockwise from outside, as bits x, y, z of the box's eight vertices.
constexpr int kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                              {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};

template <typename T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string box_bytes(const Eigen::Vector3f& size) {
    std::string bytes;
    for (const auto& face : kFaces) {
        for (const int vertex : face) {
            for (int axis = 0; axis < 3; ++axis) {
                append(bytes, size[axis] * ((vertex >> axis & 1) != 0 ? 0.5F : -0.5F));
            }
        }
    }
    for (std::uint16_t face = 0; face < 6; ++face) {
        for (const int vertex : {0, 1, 2, 0, 2, 3}) {
            append(bytes, static_cast<std::uint16_t>(face * 4 + vertex));
        }
    }
    return bytes;
}

constexpr std::size_t kVertexBytes = 24UL * 12UL;
constexpr std::size_t kIndexBytes = 36UL * 2UL;

std::string array_json(const std::vector<std::string>& items) {
    std::string text = "[";
    for (const std::string& item : items) {
        text += text.size() == 1 ? "" : ",";
        text += item;
    }
    return text + "]";
}

std::string view_json(std::size_t offset, std::size_t length) {
    std::ostringstream text;
    text << R"({"buffer":0,"byteOffset":)" << offset << R"(,"byteLength":)" << length << "}";
    return text.str();
}

std::string accessor_json(int view, int component_type, int count, const char* type) {
    std::ostringstream text;
    text << R"({"bufferView":)" << view << R"(,"componentType":)" << component_type << R"(,"count":)" << count
         << R"(,"type":")" << type << "\"}";
    return text.str();
}

std::string node_json(const std::vector<TinyNode>& nodes, std::size_t i, int mesh) {
    std::ostringstream out;
    out.precision(17);
    out << "{\"name\":\"" << nodes[i].name << "\",\"matrix\":[";
    for (int k = 0; k < 16; ++k) {
        out << (k == 0 ? "" : ",") << nodes[i].X_parent_node(k % 4, k / 4);
    }
    out << "]";
    if (mesh >= 0) {
        out << ",\"mesh\":" << mesh;
    }
    std::vector<std::string> children;
    for (std::size_t c = 0; c < nodes.size(); ++c) {
        if (nodes[c].parent == static_cast<int>(i)) {
            children.push_back(std::to_string(c));
        }
    }
    if (!children.empty()) {
        out << ",\"children\":" << array_json(children);
    }
    out << "}";
    return out.str();
}

}  // namespace

Eigen::Matrix4d translation(double x, double y, double z) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topRightCorner<3, 1>() << x, y, z;
    return m;
}

void write_gltf(const TemporaryFolder& folder, const std::string& name, const std::vector<TinyNode>& nodes) {
    std::string bin;
    std::vector<std::string> views;
    std::vector<std::string> accessors;
    std::vector<std::string> meshes;
    std::vector<std::string> node_texts;
    std::vector<std::string> roots;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        int mesh = -1;
        if (!nodes[i].size.isZero()) {
            mesh = static_cast<int>(meshes.size());
            std::ostringstream text;
            text << R"({"primitives":[{"attributes":{"POSITION":)" << 2 * mesh << R"(},"indices":)"
                 << 2 * mesh + 1 << "}]}";
            meshes.push_back(text.str());
            views.push_back(view_json(bin.size(), kVertexBytes));
            views.push_back(view_json(bin.size() + kVertexBytes, kIndexBytes));
            accessors.push_back(accessor_json(2 * mesh, 5126, 24, "VEC3"));
            accessors.push_back(accessor_json(2 * mesh + 1, 5123, 36, "SCALAR"));
            bin += box_bytes(nodes[i].size);
        }
        node_texts.push_back(node_json(nodes, i, mesh));
        if (nodes[i].parent < 0) {
            roots.push_back(std::to_string(i));
        }
    }
    std::ostringstream json;
    json << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" << array_json(roots)
         << R"(}],"nodes":)" << array_json(node_texts);
    if (!meshes.empty()) {
        json << R"(,"meshes":)" << array_json(meshes) << R"(,"accessors":)" << array_json(accessors)
             << R"(,"bufferViews":)" << array_json(views) << R"(,"buffers":[{"uri":")" << name
             << R"(.bin","byteLength":)" << bin.size() << "}]";
        folder.write(name + ".bin", bin);
    }
    json << "}";
    folder.write(name + ".gltf", json.str());
}

std::string obj_box(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                    int first_vertex) {
    std::ostringstream out;
    out << "o " << name << "\n";
    for (int vertex = 0; vertex < 8; ++vertex) {
        out << "v";
        for (int axis = 0; axis < 3; ++axis) {
            out << " " << ((vertex >> axis & 1) != 0 ? high : low)[axis];
        }
        out << "\n";
    }
    for (const auto& face : kFaces) {
        const auto index = [&](int k) { return face[k] + first_vertex; };
        out << "f " << index(0) << " " << index(1) << " " << index(2) << "\n";
        out << "f " << index(0) << " " << index(2) << " " << index(3) << "\n";
    }
    return out.str();
}

std::string tga_image(int width, int height, std::array<unsigned char, 4> rgba) {
    std::string bytes(18, '\0');
    bytes[2] = 2;  // true colour, not compressed
    bytes[12] = static_cast<char>(width & 0xFF);
    bytes[13] = static_cast<char>(width >> 8);
    bytes[14] = static_cast<char>(height & 0xFF);
    bytes[15] = static_cast<char>(height >> 8);
    bytes[16] = 32;
    bytes[17] = 0x28;  // rows from the top, eight bits of alpha
    for (int i = 0; i < width * height; ++i) {
        for (const std::size_t channel : {2U, 1U, 0U, 3U}) {
            bytes += static_cast<char>(rgba[channel]);
        }
    }
    return bytes;
}

SceneFile scene_file(const TemporaryFolder& folder, const std::string& name) {
    SceneFile file;
    file.file = name;
    file.path = folder.path() / name;
    file.mark = {"test.campus.yaml", 3, 5};
    return file;
}

fs::path shared_data() {
    const fs::path folder = CAMPUSWALK_SHARED_DATA;
    return fs::is_directory(folder) ? folder : fs::path();
}

SceneFile shared_scene(const std::string& name) {
    SceneFile file;
    file.file = name;
    file.path = shared_data() / name;
    file.mark = {"test.campus.yaml", 3, 5};
    return file;
}

std::vector<Diagnostic> errors_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.diagnostics();
    }
    return {};
}

bool has_code(const std::vector<Diagnostic>& diagnostics, const std::string& code) {
    return std::ranges::any_of(diagnostics, [&](const Diagnostic& d) { return d.code.text() == code; });
}

std::string text_of(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        text += to_string(diagnostic) + "\n";
    }
    return text;
}

double signed_volume(const Model& model) {
    double sum = 0.0;
    for (const Node& node : model.nodes) {
        for (const MeshIndex index : node.meshes) {
            const Mesh& mesh = model.meshes[index_of(index)];
            for (const auto& t : mesh.triangles) {
                std::array<Eigen::Vector3d, 3> p;
                for (std::size_t k = 0; k < 3; ++k) {
                    const Eigen::Vector4d local = mesh.positions[t[k]].cast<double>().homogeneous();
                    p[k] = (node.X_world_node * local).head<3>();
                }
                sum += p[0].dot(p[1].cross(p[2])) / 6.0;
            }
        }
    }
    return sum;
}

}  // namespace campuswalk::scene::test

namespace campuswalk::scene {

std::vector<std::byte> write_model_file(const ImportedModel& imported) {
    ArchiveWriter archive = archive_model(imported);
    return concatenated(archive.finish());
}

}  // namespace campuswalk::scene
