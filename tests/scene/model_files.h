#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "scene/campus/campus_description.h"
#include "scene/model/model.h"
#include "scene/model/model_file.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::scene::test {

using support::TemporaryFolder;

/// A node of a glTF file: a box with edge lengths `size`, centred at its origin; without a mesh if zero.
struct TinyNode {
    std::string name;
    Eigen::Vector3f size = Eigen::Vector3f::Zero();
    Eigen::Matrix4d X_parent_node = Eigen::Matrix4d::Identity();
    int parent = -1;
};

Eigen::Matrix4d translation(double x, double y, double z);

/// Writes NAME.gltf and NAME.bin: each box has 24 vertices without normals and 12 triangles.
void write_gltf(const TemporaryFolder& folder, const std::string& name, const std::vector<TinyNode>& nodes);

/// OBJ text of a box: `o NAME`, 8 vertices, 12 triangles. `first_vertex`: the index of its first vertex.
std::string obj_box(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high,
                    int first_vertex = 1);

/// An uncompressed TGA image of one colour, `rgba`.
std::string tga_image(int width, int height, std::array<unsigned char, 4> rgba);

SceneFile scene_file(const TemporaryFolder& folder, const std::string& name);
SceneFile shared_scene(const std::string& name);

/// The folder with real models; empty if it is absent.
std::filesystem::path shared_data();

/// The diagnostics of the InputError that `call` throws; empty if it doesn't throw.
std::vector<Diagnostic> errors_of(const std::function<void()>& call);
bool has_code(const std::vector<Diagnostic>& diagnostics, const std::string& code);
std::string text_of(const std::vector<Diagnostic>& diagnostics);

/// The volume that the triangles of all nodes enclose; negative if they face inwards.
double signed_volume(const Model& model);

}  // namespace campuswalk::scene::test

namespace campuswalk::scene {

/// The bytes of archive_model.
std::vector<std::byte> write_model_file(const ImportedModel& imported);

}  // namespace campuswalk::scene
