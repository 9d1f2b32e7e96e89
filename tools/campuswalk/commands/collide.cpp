#include <memory>
#include <string>
#include <vector>

#include "collision/mesh/mesh_collider.h"
#include "engine/events/decimals.h"
#include "scene/campus/campus_description.h"
#include "scene/lint/wording.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/collide/overlaps.h"
#include "tools/campuswalk/collide/parse_shape.h"
#include "tools/campuswalk/commands/commands.h"
#include "tools/campuswalk/loading/model_importer.h"

namespace campuswalk::tools {

using collide::Body;
using collide::Overlaps;

namespace {

struct CollideOptions {
    std::string a;  ///< a model file or a shape, see parse_shape.h
    std::string b;
    std::string pose;         ///< of b, see parse_pose; empty: where it is
    std::string pose_matrix;  ///< instead of `pose`
    scene::SceneFile frame;   ///< how to read the files, a and b
    bool first = false;       ///< report one pair or triangle
    bool count = false;       ///< report only how many there are
    bool json = false;
};

std::string described(const Body& body) {
    return body.mesh() == nullptr
               ? body.name
               : body.name + " (" + scene::plural(body.mesh()->mesh().triangles.size(), "triangle") + ")";
}

std::string verdict(const Overlaps& overlaps, bool first) {
    if (!overlaps.any) {
        return overlaps.distance ? "apart: " + engine::fixed(*overlaps.distance, 6) + " m" : "apart";
    }
    if (overlaps.distance || first) {
        return "overlapping";
    }
    return "overlapping: " + (overlaps.pairs.empty() ? scene::plural(overlaps.triangles.size(), "triangle")
                                                     : scene::plural(overlaps.pairs.size(), "triangle pair"));
}

/// One line about the bodies, one per pair or triangle (`a 12 b 907 "node of a" "node of b"`, `b 907 "node"`)
/// and one with the verdict; or the count alone. Names are quoted as in JSON, so that a line stays one.
void print_overlaps_as_text(const Body& a, const Body& b, const Overlaps& overlaps,
                            const CollideOptions& options) {
    if (options.count) {
        print_line("%zu", overlaps.count());
        return;
    }
    print_line("# a %s, b %s", described(a).c_str(), described(b).c_str());
    for (const collision::TrianglePair& pair : overlaps.pairs) {
        print_line("a %u b %u %s %s", pair.a, pair.b, json_text(a.node_of(pair.a)).c_str(),
                   json_text(b.node_of(pair.b)).c_str());
    }
    const bool of_a = a.mesh() != nullptr;
    for (const std::uint32_t t : overlaps.triangles) {
        print_line("%s %u %s", of_a ? "a" : "b", t, json_text((of_a ? a : b).node_of(t)).c_str());
    }
    print_line("%s", verdict(overlaps, options.first).c_str());
}

Json json_of(const Body& body) {
    Json json = {{"name", body.name}};
    if (body.mesh() != nullptr) {
        json["triangles"] = body.mesh()->mesh().triangles.size();
    }
    return json;
}

/// The pairs or triangles that overlap, under the name that fits.
void add_list(Json& json, const Body& a, const Body& b, const Overlaps& overlaps) {
    if (a.mesh() != nullptr && b.mesh() != nullptr) {
        json["pairs"] = Json::array();
        for (const collision::TrianglePair& pair : overlaps.pairs) {
            json["pairs"].push_back(
                {{"a", pair.a}, {"b", pair.b}, {"a_node", a.node_of(pair.a)}, {"b_node", b.node_of(pair.b)}});
        }
        return;
    }
    const char* side = a.mesh() != nullptr ? "a" : "b";
    const Body& body = a.mesh() != nullptr ? a : b;
    json["triangles"] = Json::array();
    for (const std::uint32_t t : overlaps.triangles) {
        json["triangles"].push_back({{side, t}, {std::string(side) + "_node", body.node_of(t)}});
    }
}

void print_overlaps_as_json(const Body& a, const Body& b, const Overlaps& overlaps,
                            const CollideOptions& options) {
    Json json = {{"a", json_of(a)}, {"b", json_of(b)}, {"overlapping", overlaps.any}};
    if (!options.first) {
        json["count"] = overlaps.count();
    }
    if (overlaps.distance) {
        json["distance"] = *overlaps.distance;
    } else if (!options.count) {
        add_list(json, a, b, overlaps);
    }
    print_lines(json_text(json, 2));
}

collision::Pose pose_of(const CollideOptions& options) {
    if (!options.pose_matrix.empty()) {
        return collide::parse_pose_matrix(options.pose_matrix);
    }
    return options.pose.empty() ? collision::Pose{} : collide::parse_pose(options.pose);
}

/// Prints where two models or shapes overlap. Returns the exit code: kPass when they are apart, kOverlapping
/// when not.
int collide_bodies(const CollideOptions& options) {
    const collision::Pose X_a_b = pose_of(options);
    std::vector<scene::Diagnostic> warnings;
    const Body a = collide::read_body(options.a, options.frame, warnings);
    const Body b = collide::read_body(options.b, options.frame, warnings);
    diagnose(warnings);
    const Overlaps overlaps =
        find_overlaps(a, b, X_a_b, options.first ? collide::SearchMode::first : collide::SearchMode::all);
    (options.json ? print_overlaps_as_json : print_overlaps_as_text)(a, b, overlaps, options);
    return overlaps.any ? kOverlapping : kPass;
}

}  // namespace

void add_collide(Command program, CommandAction& chosen) {
    const auto options = std::make_shared<CollideOptions>();
    Command command = program.add("collide", "Report where two models or shapes overlap");
    command.option({.names = "A", .help = "A model file, or a shape: see below", .required = true},
                   options->a);
    command.option({.names = "B", .help = "Likewise", .required = true}, options->b);
    command.option({.names = "--pose",
                    .help = "Pose of B: rolled, pitched, yawed, then moved",
                    .value = "X,Y,Z[,YAW[,PITCH[,ROLL]]]"},
                   options->pose);
    command.option({.names = "--pose-matrix",
                    .help = "The same as the rows of a 3 x 4 matrix",
                    .value = "12 NUMBERS",
                    .excludes = "--pose"},
                   options->pose_matrix);
    add_file_frame(command, options->frame, "the files");
    command.flag({.names = "--first", .help = "Only one pair, as soon as it is found"}, options->first);
    command.flag({.names = "--count", .help = "Only print how many there are", .excludes = "--first"},
                 options->count);
    command.flag({.names = "--json", .help = "Print JSON"}, options->json);
    add_import_options(command);
    command.footer(
        "Shapes, about the origin: box:WIDTH,HEIGHT,DEPTH, sphere:RADIUS, capsule:RADIUS,HEIGHT (upright,\n"
        "caps included), wheel:RADIUS,WIDTH (its axle along X). Metres and degrees, +Y up; roll is about Z,\n"
        "pitch about X, yaw about Y, each right-handed. A shape is filled; a model is its triangles, "
        "counted\n"
        "from 0 in the order of its nodes, and not what they enclose. Touching counts as overlapping.\n"
        "Exit code: 0 apart, 1 overlapping, 2 bad usage or input.");
    command.choose(chosen, [options] { return collide_bodies(*options); });
}

}  // namespace campuswalk::tools
