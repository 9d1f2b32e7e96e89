#include "tools/campuswalk_bench/draw/draw_peers.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "engine/render/passes/render_settings.h"
#include "scene/base/atomic_file.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk_bench/draw/looks.h"

namespace campuswalk::tools::bench {

namespace {

constexpr double kDegrees = 57.29577951308232;

nlohmann::json list_of(const Eigen::Vector3d& v) {
    return {v.x(), v.y(), v.z()};
}

}  // namespace

void write_views(const std::vector<DrawnView>& views, int rounds, const std::filesystem::path& folder) {
    const engine::render::RenderSettings ours;
    nlohmann::json all = {
        {"width", kDrawnWidth}, {"height", kDrawnHeight},         {"fov_deg", kDrawnFov * kDegrees},
        {"rounds", rounds},     {"to_sun", list_of(ours.to_sun)}, {"shadow_size", ours.shadow_size}};
    for (const DrawnView& view : views) {
        all["views"].push_back({{"eye", list_of(view.eye)}, {"target", list_of(view.target)}});
    }
    scene::write_file_atomically(folder / "views.json", all.dump(1) + '\n');
}

std::vector<DrawTimes> parse_times(const std::string& peer, const std::string& printed) {
    std::vector<DrawTimes> looks;
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string kind;
        std::string look;
        TimedImage image;
        if (!(words >> kind >> look >> image.view >> image.ms) || kind != "frame") {
            continue;
        }
        auto times = std::find_if(looks.begin(), looks.end(),
                                  [&](const DrawTimes& each) { return each.look == look; });
        if (times == looks.end()) {
            times = looks.insert(looks.end(), DrawTimes{peer, look, {}, {}});
        }
        times->images.push_back(image);
    }
    if (looks.empty()) {
        throw std::runtime_error("it drew no image");
    }
    return looks;
}

std::vector<DrawTimes> draw_peer(const std::string& name, const std::string& command,
                                 const std::filesystem::path& folder) {
    const std::string line = command + " " + shell_quoted(std::filesystem::absolute(folder).string());
    FILE* pipe = popen(line.c_str(), "r");  // NOLINT(cert-env33-c): the user's own command line
    if (pipe == nullptr) {
        throw std::runtime_error("its command can't be run");
    }
    std::string printed;
    std::array<char, 4096> piece{};
    while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe)) {
        printed.append(piece.data(), count);
    }
    const int status = pclose(pipe);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        throw std::runtime_error("its command failed");
    }
    return parse_times(name, printed);
}

}  // namespace campuswalk::tools::bench
