#include "tests/config/config_folder.h"
#include "config/loader/load_profile.h"

namespace campuswalk::config::test {

namespace {

constexpr const char* kCampus = R"(scenes: [{file: a.obj}]
layers: [ground, trees]
buildings: [{id: hut, title: Hut}]
colliders:
  - {id: ground, nodes: floor, shape: mesh, mode: solid}
spawns:
  gate: {at: [1, 0, 5], yaw_deg: 90}
places:
  square: [2, 0, -3]
)";

constexpr const char* kWalk = R"(campus: a.campus.yaml
avatar: adult
steps:
  - spawn: gate
  - walk_to: square
)";

}  // namespace

ConfigFolder::ConfigFolder() {
    write("a.campus.yaml", kCampus);
    write("a.walk.yaml", kWalk);
    write("avatars/adult.avatar.yaml", "height: 1.8\n");
}

Lines ConfigFolder::about_campus(std::string_view text) const {
    write("a.campus.yaml", text);
    return formatted_diagnostics_of([&] { campus(); });
}

Lines ConfigFolder::about_avatar(std::string_view text) const {
    write("an.avatar.yaml", text);
    return formatted_diagnostics_of([&] { load_avatar(path("an.avatar.yaml")); });
}

Lines ConfigFolder::about_walk(std::string_view text) const {
    write("a.walk.yaml", text);
    return about_run();
}

Lines ConfigFolder::about_run() const {
    return formatted_diagnostics_of([&] { run(); });
}

Lines ConfigFolder::about_steps(const std::string& text) const {
    return about_walk("campus: a.campus.yaml\nsteps:\n" + text);
}

Lines ConfigFolder::about_expectations(const std::string& text) const {
    return about_walk("campus: a.campus.yaml\nsteps: [{spawn: gate}]\nexpect:\n" + text);
}

Lines ConfigFolder::about_collider(const std::string& text) const {
    return about_campus(
        "scenes: [{file: a.obj}]\nlayers: [ground, trees]\nbuildings: [{id: hut, title: Hut}]\ncolliders:\n  "
        "- " +
        text);
}

Lines ConfigFolder::formatted_diagnostics_of(const std::function<void()>& load) const {
    const std::string prefix = folder_.path().string() + "/";
    Lines lines;
    for (const scene::Diagnostic& diagnostic : diagnostics_of(load)) {
        std::string line = scene::to_string(diagnostic);
        for (std::size_t at = 0; (at = line.find(prefix, at)) != std::string::npos;) {
            line.erase(at, prefix.size());
        }
        lines.push_back(std::move(line));
    }
    return lines;
}

std::vector<scene::Diagnostic> diagnostics_of(const std::function<void()>& load) {
    try {
        load();
    } catch (const scene::InputError& error) {
        return error.diagnostics();
    }
    return {};
}

}  // namespace campuswalk::config::test
