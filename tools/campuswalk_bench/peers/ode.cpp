// ODE's dCollide of two triangle meshes (with OPCODE). Its contacts name the triangles; it merges and drops
// contacts, and their pairs with them.

#include <cstdarg>

#include <ode/ode.h>

#include "tools/campuswalk_bench/engine/engine.h"

namespace campuswalk::tools::bench {

namespace {

using collision::TrianglePair;

/// A mesh in ODE, which reads its vertices and triangles in place.
class Body {
public:
    explicit Body(const collision::TriangleMesh& mesh) : data_(dGeomTriMeshDataCreate()) {
        dGeomTriMeshDataBuildSingle(data_, mesh.positions.data(), sizeof(mesh.positions[0]),
                                    static_cast<int>(mesh.positions.size()), mesh.triangles.data(),
                                    static_cast<int>(3 * mesh.triangles.size()), sizeof(mesh.triangles[0]));
        geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    }
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;
    ~Body() {
        dGeomDestroy(geometry_);
        dGeomTriMeshDataDestroy(data_);
    }

    dGeomID geometry() const { return geometry_; }

private:
    dTriMeshDataID data_ = nullptr;
    dGeomID geometry_ = nullptr;
};

/// The library as a whole, opened before any body and closed after the last.
struct Library {
    Library() {
        dInitODE2(0);
        // It prints to standard error, about a thousand times per query, that its table of contacts is full.
        dSetMessageHandler([](int, const char*, va_list) {});
        dAllocateODEDataForThread(dAllocateMaskAll);
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    ~Library() { dCloseODE(); }
};

class Ode final : public Engine {
public:
    Ode(const collision::TriangleMesh& a, const collision::TriangleMesh& b) : a_(a), b_(b), contacts_(kMax) {}

    void set_pose(const collision::Pose& X_a_b) override {
        dMatrix3 R = {};
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                R[4 * row + column] = static_cast<dReal>(X_a_b.rotation(row, column));
            }
        }
        dGeomSetRotation(b_.geometry(), R);
        const collision::Vec3& t = X_a_b.translation;
        dGeomSetPosition(b_.geometry(), static_cast<dReal>(t.x()), static_cast<dReal>(t.y()),
                         static_cast<dReal>(t.z()));
    }

    void all_pairs(std::vector<TrianglePair>& out) override {
        const std::size_t found = collide(kMax);
        out.clear();
        for (std::size_t i = 0; i < found; ++i) {
            out.push_back(pair(i));
        }
    }

    std::optional<TrianglePair> first_pair() override {
        return collide(1) > 0 ? std::optional(pair(0)) : std::nullopt;
    }

private:
    static constexpr int kMax = 0xFFFF;  ///< contacts; dCollide's flags have 16 bits for the number

    std::size_t collide(int most) {
        return static_cast<std::size_t>(
            dCollide(a_.geometry(), b_.geometry(), most, contacts_.data(), sizeof(dContactGeom)));
    }

    TrianglePair pair(std::size_t i) const {
        return {static_cast<std::uint32_t>(contacts_[i].side1),
                static_cast<std::uint32_t>(contacts_[i].side2)};
    }

    Library library_;
    Body a_;
    Body b_;
    std::vector<dContactGeom> contacts_;
};

}  // namespace

extern "C" Engine* campuswalk_make_engine(const collision::TriangleMesh& a,
                                          const collision::TriangleMesh& b) {
    return new Ode(a, b);
}

}  // namespace campuswalk::tools::bench
