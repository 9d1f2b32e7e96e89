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

// The corners of a face, counter-clockwise from outside, as bits x, y, z of the box's eight corners.
constexpr int kFaces[6][4] = {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3},
                              {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}};

template <typename T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string box_bytes(const Eigen::Vector3f& size) {
    std::string bytes;
    for (const auto& face : kFaces) {
        for (const int corner : face) {
            for (int axis = 0; axis < 3; ++axis) {
                append(bytes, size[axis] * ((corner >> axis & 1) != 0 ? 0.5F : -0.5F));
            }
        }
    }
    for (std::uint16_t face = 0; face < 6; ++face) {
        for (const int corner : {0, 1, 2, 0, 2, 3}) {
            append(bytes, static_cast<std::uint16_t>(face * 4 + corner));
        }
    }
    return bytes;
}

constexpr std::size_t kVertexBytes = 24 * 12;
constexpr std::size_t kIndexBytes = 36 * 2;

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
    std::string children;
    for (std::size_t c = 0; c < nodes.size(); ++c) {
        if (nodes[c].parent == static_cast<int>(i)) {
            children += (children.empty() ? "" : ",") + std::to_string(c);
        }
    }
    if (!children.empty()) {
        out << ",\"children\":[" << children << "]";
    }
    out << "}";
    return out.str();
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "campuswalk-XXXXXX").string();
    path_ = mkdtemp(name.data());
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void TemporaryFolder::write(const std::string& name, std::string_view bytes) const {
    const fs::path file = path_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

Eigen::Matrix4d translation(double x, double y, double z) {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topRightCorner<3, 1>() << x, y, z;
    return m;
}

void write_gltf(const TemporaryFolder& folder, const std::string& name, const std::vector<TinyNode>& nodes) {
    std::string bin;
    std::string views;
    std::string accessors;
    std::string meshes;
    std::string node_list;
    std::string roots;
    int mesh_count = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        int mesh = -1;
        if (!nodes[i].size.isZero()) {
            const std::string at = std::to_string(bin.size());
            const std::string indices_at = std::to_string(bin.size() + kVertexBytes);
            const std::string first = std::to_string(2 * mesh_count);
            const std::string second = std::to_string(2 * mesh_count + 1);
            const std::string comma = mesh_count == 0 ? "" : ",";
            views += comma + "{\"buffer\":0,\"byteOffset\":" + at +
                     ",\"byteLength\":" + std::to_string(kVertexBytes) +
                     "},{\"buffer\":0,\"byteOffset\":" + indices_at +
                     ",\"byteLength\":" + std::to_string(kIndexBytes) + "}";
            accessors += comma + "{\"bufferView\":" + first +
                         ",\"componentType\":5126,\"count\":24,\"type\":\"VEC3\"},{\"bufferView\":" + second +
                         ",\"componentType\":5123,\"count\":36,\"type\":\"SCALAR\"}";
            meshes += comma + "{\"primitives\":[{\"attributes\":{\"POSITION\":" + first +
                      "},\"indices\":" + second + "}]}";
            bin += box_bytes(nodes[i].size);
            mesh = mesh_count++;
        }
        node_list += (i == 0 ? "" : ",") + node_json(nodes, i, mesh);
        if (nodes[i].parent < 0) {
            roots += (roots.empty() ? "" : ",") + std::to_string(i);
        }
    }
    std::string json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots +
                       "]}],\"nodes\":[" + node_list + "]";
    if (mesh_count > 0) {
        json += ",\"meshes\":[" + meshes + "],\"accessors\":[" + accessors + "],\"bufferViews\":[" + views +
                "],\"buffers\":[{\"uri\":\"" + name + ".bin\",\"byteLength\":" + std::to_string(bin.size()) +
                "}]";
        folder.write(name + ".bin", bin);
    }
    folder.write(name + ".gltf", json + "}");
}

std::string obj_box(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                    int first_vertex) {
    std::ostringstream out;
    out << "o " << name << "\n";
    for (int corner = 0; corner < 8; ++corner) {
        out << "v";
        for (int axis = 0; axis < 3; ++axis) {
            out << " " << ((corner >> axis & 1) != 0 ? high : low)[axis];
        }
        out << "\n";
    }
    for (const auto& face : kFaces) {
        const auto vertex = [&](int k) { return face[k] + first_vertex; };
        out << "f " << vertex(0) << " " << vertex(1) << " " << vertex(2) << "\n";
        out << "f " << vertex(0) << " " << vertex(2) << " " << vertex(3) << "\n";
    }
    return out.str();
}

std::string tga_picture(int width, int height, std::array<unsigned char, 4> rgba) {
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
    return std::ranges::any_of(diagnostics, [&](const Diagnostic& d) { return d.code == code; });
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
