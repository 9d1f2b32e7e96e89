// Where FBX nodes and their meshes are, beside the closed form of Autodesk's FBX SDK ("Computing
// transformation matrices"):
//   node     = parent * T * Roff * Rp * Rpre * R * Rpost^-1 * Rp^-1 * Soff * Sp * S * Sp^-1
//   its mesh = node * OT * OR * OS, which children don't inherit.

#include <array>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "scene/import/import_model.h"
#include "tests/scene/model_files.h"

namespace campuswalk::scene {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

struct FbxNode {
    std::string name;
    int parent = -1;
    Vector3d translation = Vector3d::Zero();
    Vector3d rotation_deg = Vector3d::Zero();
    Vector3d scaling = Vector3d::Ones();
    Vector3d rotation_offset = Vector3d::Zero();
    Vector3d rotation_pivot = Vector3d::Zero();
    Vector3d pre_rotation_deg = Vector3d::Zero();
    Vector3d post_rotation_deg = Vector3d::Zero();
    Vector3d scaling_offset = Vector3d::Zero();
    Vector3d scaling_pivot = Vector3d::Zero();
    Vector3d geometric_translation = Vector3d::Zero();
    Vector3d geometric_rotation_deg = Vector3d::Zero();
    Vector3d geometric_scaling = Vector3d::Ones();
    int rotation_order = 0;
};

const std::array<const char*, 6> kOrders = {"XYZ", "XZY", "YZX", "YXZ", "ZXY", "ZYX"};

/// The first axis of the order turns first.
Affine3d rotation(const Vector3d& degrees, const std::string& order) {
    Affine3d result = Affine3d::Identity();
    for (const char axis : order) {
        const int k = axis - 'X';
        result = Eigen::AngleAxisd(degrees[k] * M_PI / 180.0, Vector3d::Unit(k)) * result;
    }
    return result;
}

Affine3d node_transform(const FbxNode& n) {
    using Eigen::Translation3d;
    return Translation3d(n.translation) * Translation3d(n.rotation_offset) * Translation3d(n.rotation_pivot) *
           rotation(n.pre_rotation_deg, "XYZ") *
           rotation(n.rotation_deg, kOrders.at(static_cast<std::size_t>(n.rotation_order))) *
           rotation(n.post_rotation_deg, "XYZ").inverse() * Translation3d(-n.rotation_pivot) *
           Translation3d(n.scaling_offset) * Translation3d(n.scaling_pivot) * Eigen::Scaling(n.scaling) *
           Translation3d(-n.scaling_pivot);
}

Affine3d geometric_transform(const FbxNode& n) {
    return Eigen::Translation3d(n.geometric_translation) * rotation(n.geometric_rotation_deg, "XYZ") *
           Eigen::Scaling(n.geometric_scaling);
}

const std::array<Vector3d, 3> kTriangle = {Vector3d(0.5, 0, 0), Vector3d(0, 2, 0.25), Vector3d(-1, 0.75, 3)};

std::string fbx_text(const std::vector<FbxNode>& nodes) {
    std::ostringstream out;
    out.precision(17);
    const auto vector = [&out](const char* name, const char* type, const Vector3d& v) {
        out << "   P: \"" << name << "\", \"" << type << "\", \"\", \"A\"," << v.x() << ',' << v.y() << ','
            << v.z() << '\n';
    };
    out << "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
        << "GlobalSettings:  {\n Version: 1000\n Properties70:  {\n"
        << "  P: \"UpAxis\", \"int\", \"Integer\", \"\",1\n  P: \"UpAxisSign\", \"int\", \"Integer\", "
           "\"\",1\n"
        << "  P: \"FrontAxis\", \"int\", \"Integer\", \"\",2\n  P: \"FrontAxisSign\", \"int\", \"Integer\", "
           "\"\",1\n"
        << "  P: \"CoordAxis\", \"int\", \"Integer\", \"\",0\n  P: \"CoordAxisSign\", \"int\", \"Integer\", "
           "\"\",1\n"
        << "  P: \"UnitScaleFactor\", \"double\", \"Number\", \"\",100\n }\n}\nObjects:  {\n";
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const FbxNode& n = nodes[i];
        out << " Geometry: " << 1000 + i << ", \"Geometry::" << n.name
            << "\", \"Mesh\" {\n  Vertices: *9 {\n   a: ";
        for (std::size_t k = 0; k < 9; ++k) {
            out << (k == 0 ? "" : ",") << kTriangle[k / 3][static_cast<Eigen::Index>(k % 3)];
        }
        out << "\n  }\n  PolygonVertexIndex: *3 {\n   a: 0,1,-3\n  }\n  GeometryVersion: 124\n }\n"
            << " Model: " << 2000 + i << ", \"Model::" << n.name
            << "\", \"Mesh\" {\n  Version: 232\n  Properties70:  {\n"
            << "   P: \"RotationActive\", \"bool\", \"\", \"\",1\n   P: \"InheritType\", \"enum\", \"\", "
               "\"\",1\n"
            << "   P: \"RotationOrder\", \"enum\", \"\", \"\"," << n.rotation_order << '\n';
        vector("Lcl Translation", "Lcl Translation", n.translation);
        vector("Lcl Rotation", "Lcl Rotation", n.rotation_deg);
        vector("Lcl Scaling", "Lcl Scaling", n.scaling);
        vector("RotationOffset", "Vector3D", n.rotation_offset);
        vector("RotationPivot", "Vector3D", n.rotation_pivot);
        vector("PreRotation", "Vector3D", n.pre_rotation_deg);
        vector("PostRotation", "Vector3D", n.post_rotation_deg);
        vector("ScalingOffset", "Vector3D", n.scaling_offset);
        vector("ScalingPivot", "Vector3D", n.scaling_pivot);
        vector("GeometricTranslation", "Vector3D", n.geometric_translation);
        vector("GeometricRotation", "Vector3D", n.geometric_rotation_deg);
        vector("GeometricScaling", "Vector3D", n.geometric_scaling);
        out << "  }\n }\n";
    }
    out << "}\nConnections:  {\n";
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        out << " C: \"OO\"," << 2000 + i << ',' << (nodes[i].parent < 0 ? 0 : 2000 + nodes[i].parent) << '\n'
            << " C: \"OO\"," << 1000 + i << ',' << 2000 + i << '\n';
    }
    out << "}\n";
    return out.str();
}

class FbxTransformTest : public testing::Test {
protected:
    /// Whether each node is there once, below its parent, and its triangle where the closed form puts it.
    void expect_closed_form(const std::vector<FbxNode>& nodes) {
        folder_.write("x.fbx", fbx_text(nodes));
        const Model model = import_model(test::scene_file(folder_, "x.fbx"), EmptyModel::refuse).model;
        ASSERT_EQ(model.nodes.size(), nodes.size() + 1);  // and the root
        std::vector<Affine3d> X_world_node;
        for (const FbxNode& node : nodes) {
            const Affine3d X_world_parent =
                node.parent < 0 ? Affine3d::Identity() : X_world_node[static_cast<std::size_t>(node.parent)];
            X_world_node.push_back(X_world_parent * node_transform(node));
            const auto found = std::ranges::find(model.nodes, node.name, &Node::name);
            ASSERT_NE(found, model.nodes.end()) << node.name;
            const std::string& parent = model.nodes[static_cast<std::size_t>(found->parent)].name;
            EXPECT_EQ(parent,
                      node.parent < 0 ? "RootNode" : nodes[static_cast<std::size_t>(node.parent)].name);
            ASSERT_EQ(found->meshes.size(), 1U);
            const Mesh& mesh = model.meshes[index_of(found->meshes[0])];
            for (const Vector3d& vertex : kTriangle) {
                const Vector3d expected = X_world_node.back() * geometric_transform(node) * vertex;
                double nearest = 1e9;
                for (const Eigen::Vector3f& position : mesh.positions) {
                    const Vector3d p =
                        (found->X_world_node * position.cast<double>().homogeneous()).head<3>();
                    nearest = std::min(nearest, (p - expected).norm());
                }
                EXPECT_LT(nearest, 2e-4) << node.name;  // assimp's matrices are of single precision
            }
        }
    }

    test::TemporaryFolder folder_;
};

TEST_F(FbxTransformTest, GeometricTransformsMoveTheirOwnMeshAlone) {
    FbxNode wall{.name = "wall", .translation = {3, 0, 4}};
    wall.geometric_translation = {0, 1, 2};
    wall.geometric_rotation_deg = {0, 40, 0};
    wall.geometric_scaling = {2, 1, 3};
    const FbxNode child{.name = "child", .parent = 0, .translation = {5, 0, 0}, .rotation_deg = {0, 20, 0}};
    const FbxNode grandchild{.name = "grandchild", .parent = 1, .translation = {0, 0, 7}};
    expect_closed_form({wall, child, grandchild});
}

TEST_F(FbxTransformTest, AMeshThatIsScaledToNothingLeavesItsChildren) {
    FbxNode flat{.name = "flat", .translation = {3, 0, 4}};
    flat.geometric_scaling = {1, 0, 1};
    expect_closed_form({flat, {.name = "child", .parent = 0, .translation = {5, 0, 0}}});
}

TEST_F(FbxTransformTest, PostRotationIsInverted) {
    FbxNode door{.name = "door", .rotation_deg = {0, 30, 0}};
    door.post_rotation_deg = {10, 20, 30};
    expect_closed_form({door});
    door.pre_rotation_deg = {-90, 0, 15};
    expect_closed_form({door});
}

TEST_F(FbxTransformTest, TurnsAxesInTheirOrder) {
    for (int order = 0; order < 6; ++order) {
        SCOPED_TRACE(kOrders.at(static_cast<std::size_t>(order)));
        FbxNode node{.name = "node", .rotation_deg = {20, 40, 70}};
        node.rotation_order = order;
        expect_closed_form({node, {.name = "child", .parent = 0, .translation = {1, 2, 3}}});
    }
}

TEST_F(FbxTransformTest, RandomHierarchiesAgreeWithTheClosedForm) {
    std::mt19937 random(52);
    const auto number = [&random](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    const auto offset = [&] {
        return random() % 2 == 0 ? Vector3d(Vector3d::Zero())
                                 : Vector3d(number(-3, 3), number(-3, 3), number(-3, 3));
    };
    const auto angles = [&] {
        return random() % 2 == 0 ? Vector3d(Vector3d::Zero())
                                 : Vector3d(number(-180, 180), number(-90, 90), number(-180, 180));
    };
    const auto factors = [&] {
        return random() % 2 == 0 ? Vector3d(Vector3d::Ones())
                                 : Vector3d(number(0.3, 2), -number(0.3, 2), number(0.3, 2));
    };
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        std::vector<FbxNode> nodes;
        for (int i = 0; i < 4; ++i) {
            FbxNode node;
            node.name = "n" + std::to_string(i);
            node.parent = static_cast<int>(random() % static_cast<unsigned>(i + 1)) - 1;
            node.translation = offset();
            node.rotation_deg = angles();
            node.scaling = factors();
            node.rotation_offset = offset();
            node.rotation_pivot = offset();
            node.pre_rotation_deg = angles();
            node.post_rotation_deg = angles();
            node.scaling_offset = offset();
            node.scaling_pivot = offset();
            node.geometric_translation = offset();
            node.geometric_scaling = factors();
            node.rotation_order = static_cast<int>(random() % 6);
            // assimp turns it in the node's order, the SDK as XYZ: the same about one axis.
            node.geometric_rotation_deg[static_cast<Eigen::Index>(random() % 3)] = number(-180, 180);
            nodes.push_back(node);
        }
        expect_closed_form(nodes);
    }
}

}  // namespace
}  // namespace campuswalk::scene
