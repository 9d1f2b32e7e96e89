
#include "tools/campuswalk/info/model_info.h"

#include "tools/campuswalk/suggest/frame_text.h"

namespace campuswalk::tools {

namespace {

Json json_of(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

/// Null for empty bounds.
Json json_of(const scene::Bounds& bounds) {
    return bounds.empty() ? Json() : Json{{"min", json_of(bounds.min)}, {"max", json_of(bounds.max)}};
}

Json json_of(const std::optional<scene::GeographicPlace>& place) {
    return place ? Json{{"latitude_deg", place->latitude_deg},
                        {"longitude_deg", place->longitude_deg},
                        {"height", place->height},
                        {"at", json_of(place->at)}}
                 : Json();
}

Json json_of(const std::optional<engine::GroundCover>& ground) {
    return ground ? Json{{"area", ground->area},
                         {"complete", !ground->is_cut_short},
                         {"seen", ground->seen},
                         {"height", ground->height}}
                  : Json();
}

Json json_of(const std::optional<PlaceCount>& places) {
    return places ? Json{{"named", places->named}, {"within_bounds", places->within_bounds}} : Json();
}

const char* name_of(scene::AlphaMode mode) {
    switch (mode) {
        case scene::AlphaMode::mask:
            return "mask";
        case scene::AlphaMode::blend:
            return "blend";
        default:
            return "opaque";
    }
}

Json json_of(const scene::SuggestedBuilding& building) {
    return {{"id", building.id},
            {"title", building.title},
            {"nodes", building.globs},
            {"center", json_of(building.box.center)},
            {"size", json_of(building.box.size)},
            {"along", json_of(building.box.along)}};
}

Json json_of(const scene::Door& door) {
    return {{"node", door.node},
            {"at", json_of(door.foot)},
            {"width", door.width},
            {"height", door.height},
            {"closed", door.is_closed}};
}

Json json_of(const scene::Flight& flight) {
    return {{"node", flight.node},
            {"at", json_of(flight.foot)},
            {"risers", flight.risers},
            {"tread_depth", flight.tread_depth},
            {"width", flight.width}};
}

Json json_of(const scene::ModelLint& lint) {
    Json warning = {{"code", lint.code.text()}, {"message", lint.message}};
    for (const scene::ModelLint::Place& place : lint.places) {
        warning["places"].push_back({{"node", place.node}, {"at", json_of(place.at)}});
    }
    return warning;
}

Json json_of(const scene::MaterialReport& material) {
    return {{"name", material.name},
            {"texture", material.texture.empty() ? Json() : Json(material.texture)},
            {"triangles", material.triangles},
            {"alpha_mode", name_of(material.alpha_mode)},
            {"double_sided", material.double_sided}};
}

Json json_of(const scene::TextureReport& texture) {
    return {{"name", texture.name}, {"width", texture.width}, {"height", texture.height}};
}

Json json_of(const scene::NodeReport& node) {
    return {{"name", node.name},           {"parent", node.parent < 0 ? Json() : Json(node.parent)},
            {"depth", node.depth},         {"triangles", node.triangles},
            {"materials", node.materials}, {"bounds", json_of(node.bounds)}};
}

/// What is there of a kind, and what is usual.
Json json_of(const scene::Measure& measure) {
    const scene::UsualSize& usual = scene::usual_size(measure.kind);
    return {{"what", usual.name},
            {"count", measure.count},
            {"median", measure.median},
            {"usual", {usual.low, usual.high}}};
}

Json json_of(const scene::UpVote& vote) {
    return {{"what", tools::name_of(vote.kind)}, {"y", vote.y}, {"z", vote.z}};
}

template <typename Part>
Json list_of(const std::vector<Part>& parts) {
    Json list = Json::array();
    for (const Part& part : parts) {
        list.push_back(json_of(part));
    }
    return list;
}

/// What the model is read with, and what the guess says of it before that.
Json json_of(const UprightModel& upright) {
    const scene::FrameGuess& frame = upright.frame;
    return {{"up", upright.file.up == scene::UpAxis::z ? "z" : "y"},
            {"scale", upright.file.scale},
            {"turned", upright.is_turned},
            {"scaled", upright.is_scaled},
            {"guess",
             {{"up", frame.up == scene::UpAxis::z ? "z" : "y"},
              {"up_confidence", tools::name_of(frame.up_confidence)},
              {"votes", list_of(frame.votes)},
              {"scale", frame.scale},
              {"scale_confidence", tools::name_of(frame.scale_confidence)},
              {"measures", list_of(frame.measures)}}}};
}

}  // namespace

Json json_of(const ModelInfo& info) {
    const scene::ModelReport& report = info.upright.report;
    return {{"campuswalk_info", 3},
            {"file", report.file},
            {"frame", json_of(info.upright)},
            {"bounds", json_of(report.bounds)},
            {"origin_near", json_of(scene::origin_near(report.bounds))},
            {"geographic", json_of(report.geographic)},
            {"ground", json_of(info.ground)},
            {"buildings", list_of(info.buildings.list)},
            {"more_buildings", info.buildings.left_out},
            {"doors", list_of(report.doors)},
            {"flights", list_of(report.flights)},
            {"places", json_of(info.places)},
            {"meshes", report.meshes},
            {"placements", report.placements},
            {"triangles", report.triangles},
            {"vertices", report.vertices},
            {"materials", list_of(report.materials)},
            {"textures", list_of(report.textures)},
            {"nodes", list_of(report.nodes)},
            {"warnings", list_of(report.warnings)}};
}

}  // namespace campuswalk::tools
