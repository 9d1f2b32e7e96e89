#include "tools/campuswalk/collide/parse_shape.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "collision/geometry/trigonometry.h"
#include "config/loader/values/number.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/texts_of.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools::collide {

using collision::Mat3;
using collision::Pose;
using collision::Shape;
using collision::Vec3;
using config::Range;

namespace {

constexpr Range kSize{0.0, 1e6, true, "m"};
constexpr Range kTranslation{-1e9, 1e9, false, "m"};
constexpr Range kAngle{-36000.0, 36000.0, false, "degrees"};
constexpr Range kMatrixEntry{-1e9, 1e9, false, ""};

/// One number of a list.
struct Field {
    std::string_view name;
    Range range;
};

/// An argument that is being parsed, and how to report that it is wrong.
struct Argument {
    std::string text;
    scene::DiagnosticCode code;
    std::string expected;  ///< the end of every diagnostic

    [[noreturn]] void refuse(const std::string& why) const {
        throw error_about(text, code, why + "; " + expected);
    }

    /// The values of the fields; those after the first `least` may be omitted and are 0 then.
    std::vector<double> numbers(std::string_view list, std::span<const Field> fields,
                                std::size_t least) const {
        const std::vector<std::string_view> parts = split(list, ',');
        const std::size_t count = list.empty() ? 0 : parts.size();
        if (count < least || count > fields.size()) {
            std::string needed = std::to_string(least);
            if (least < fields.size()) {
                needed += " to " + std::to_string(fields.size());
            }
            needed += fields.size() == 1 ? " number is" : " numbers are";
            refuse(needed + " needed, not " + std::to_string(count));
        }
        std::vector<double> values(fields.size(), 0.0);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const config::ParsedNumber number = config::parse_number(parts[i], fields[i].range);
            if (!number.code.empty()) {
                refuse("the " + std::string(fields[i].name) + " " + number.message);
            }
            values[i] = number.value;
        }
        return values;
    }
};

struct Kind {
    std::string_view name;
    std::string_view expected;
    std::vector<Field> fields;
};

const std::array<Kind, 4>& kinds() {
    static const std::array<Kind, 4> all = {{
        {"box",
         "write box:WIDTH,HEIGHT,DEPTH in metres, as in box:1,1,1",
         {{"width", kSize}, {"height", kSize}, {"depth", kSize}}},
        {"sphere", "write sphere:RADIUS in metres, as in sphere:0.5", {{"radius", kSize}}},
        {"capsule",
         "write capsule:RADIUS,HEIGHT in metres, caps included, as in capsule:0.3,1.8",
         {{"radius", kSize}, {"height", kSize}}},
        {"wheel",
         "write wheel:RADIUS,WIDTH in metres, as in wheel:0.3,0.2",
         {{"radius", kSize}, {"width", kSize}}},
    }};
    return all;
}

/// Letters followed by a colon are meant as a shape, unless there is a file of that name.
void refuse_unknown_kind(const std::string& argument, std::string_view name) {
    const bool looks_like_a_shape =
        name.size() > 1 && name.size() < argument.size() &&
        std::ranges::all_of(name, [](unsigned char c) { return std::isalpha(c) != 0; });
    if (!looks_like_a_shape || std::filesystem::exists(argument)) {
        return;
    }
    throw error_about(argument, "unknown-shape",
                      "no shape is called " + config::in_quotes(name) +
                          config::suggestion_or_list(name, scene::texts_of(kinds(), &Kind::name)) +
                          "; write box:1,1,1 or a model file");
}

/// `axis` is 0 for X, 1 for Y, 2 for Z.
Mat3 rotation_about(double degrees, int axis) {
    constexpr double kRadians = 3.14159265358979323846 / 180.0;
    const auto [sin, cos] = collision::sin_cos(degrees * kRadians);
    // Quarter turns map axes to axes exactly, so that what touches before a turn touches after it.
    const bool quarter = std::fmod(degrees, 90.0) == 0.0;
    const double s = quarter ? std::round(sin) : sin;
    const double c = quarter ? std::round(cos) : cos;
    const int i = (axis + 1) % 3;
    const int j = (axis + 2) % 3;
    Mat3 R = Mat3::Identity();
    R(i, i) = c;
    R(i, j) = -s;
    R(j, i) = s;
    R(j, j) = c;
    return R;
}

}  // namespace

std::optional<Shape> parse_shape(const std::string& argument) {
    const std::size_t colon = argument.find(':');
    const std::string_view name = std::string_view(argument).substr(0, colon);
    const auto kind = std::ranges::find(kinds(), name, &Kind::name);
    if (kind == kinds().end()) {
        refuse_unknown_kind(argument, name);
        return std::nullopt;
    }
    const std::string_view list =
        colon == std::string::npos ? std::string_view() : std::string_view(argument).substr(colon + 1);
    const Argument read{argument, "bad-shape", std::string(kind->expected)};
    const std::vector<double> n = read.numbers(list, kind->fields, kind->fields.size());
    if (name == "box") {
        return collision::Box{0.5 * Vec3(n[0], n[1], n[2])};
    }
    if (name == "sphere") {
        return collision::Sphere{n[0]};
    }
    if (name == "wheel") {
        return collision::Wheel{n[0], 0.5 * n[1]};
    }
    if (n[1] < 2.0 * n[0]) {
        read.refuse("the height must be twice the radius or more");
    }
    return collision::Capsule{n[0], 0.5 * n[1] - n[0]};
}

Pose parse_pose(const std::string& argument) {
    static constexpr std::array<Field, 6> kFields = {{{"x", kTranslation},
                                                      {"y", kTranslation},
                                                      {"z", kTranslation},
                                                      {"yaw", kAngle},
                                                      {"pitch", kAngle},
                                                      {"roll", kAngle}}};
    const Argument read{"--pose " + argument, "bad-pose",
                        "write x,y,z in metres, then yaw, pitch and roll in degrees where they aren't 0, "
                        "as in 0,1.5,-2,90"};
    const std::vector<double> n = read.numbers(argument, kFields, 3);
    Pose pose;
    pose.translation = Vec3(n[0], n[1], n[2]);
    pose.rotation = rotation_about(n[3], 1) * rotation_about(n[4], 0) * rotation_about(n[5], 2);
    return pose;
}

Pose parse_pose_matrix(const std::string& argument) {
    static constexpr Field kField{"matrix entry", kMatrixEntry};
    static const std::vector<Field> fields(12, kField);
    const Argument read{"--pose-matrix " + argument, "bad-pose",
                        "write the rows of a rotation, each followed by the move along its axis in metres, "
                        "as in 1,0,0,0.5,0,1,0,0,0,0,1,-2"};
    const std::vector<double> n = read.numbers(argument, fields, fields.size());
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        const std::size_t at = std::size_t{4} * static_cast<std::size_t>(row);
        pose.rotation.row(row) << n[at], n[at + 1], n[at + 2];
        pose.translation[row] = n[at + 3];
    }
    const Mat3& R = pose.rotation;
    const bool is_orthonormal = (R * R.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff() <= 1e-3;
    if (!is_orthonormal || R.determinant() < 0.0) {
        read.refuse(is_orthonormal ? "the matrix mirrors" : "the matrix isn't a rotation");
    }
    return pose;
}

}  // namespace campuswalk::tools::collide
