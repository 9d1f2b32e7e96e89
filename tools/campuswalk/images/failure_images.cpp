#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"
#include "engine/render/image/png.h"
#include "engine/render/overlay/canvas.h"
#include "engine/render/overlay/map_marks.h"
#include "engine/render/overlay/walk_trail.h"
#include "engine/render/snapshot/renderer_store.h"
#include "engine/report/outcome.h"
#include "engine/simulation/simulation.h"
#include "tools/campuswalk/images/contact_camera.h"
#include "tools/campuswalk/images/images.h"
#include "tools/campuswalk/images/map_image.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;
namespace render = engine::render;
using Eigen::Vector3d;

namespace {

constexpr std::size_t kMaxMoments = 4;
constexpr int kWidth = 1280;  // pixels
constexpr int kHeight = 720;  // pixels
/// As far around what is in the way colliders are outlined, metres: all of them would hide it.
constexpr double kOutlined = 4.0;

/// The first failures' ticks, in order; none of a walk that should have failed and didn't.
std::vector<engine::Tick> moments_of(std::span<const engine::Failure> failures) {
    std::set<engine::Tick> ticks;
    for (const engine::Failure& failure : failures) {
        if (ticks.size() < kMaxMoments && failure.code != engine::kXfailCode) {
            ticks.insert(failure.scene.tick);
        }
    }
    return {ticks.begin(), ticks.end()};
}

/// What the failures of a moment are about.
std::optional<Vector3d> contact_of(std::span<const engine::Failure> failures, engine::Tick tick) {
    for (const engine::Failure& failure : failures) {
        if (failure.scene.tick == tick && failure.scene.contact) {
            return failure.scene.contact;
        }
    }
    return std::nullopt;
}

std::string caption_of(std::span<const engine::Failure> failures, engine::Tick tick, double time) {
    std::string codes;
    for (const engine::Failure& failure : failures) {
        if (failure.scene.tick == tick && codes.find(failure.code) == std::string::npos) {
            codes += (codes.empty() ? "" : ", ") + failure.code;
        }
    }
    return codes + " \u00b7 " + engine::fixed(time, 2) + " s";
}

/// Draws moments of one walk, which come in order.
class FailureImageRenderer {
public:
    FailureImageRenderer(const scene::Campus& campus, const engine::Walk& walk,
                         render::SnapshotRenderer& snapshot_renderer, fs::path output, fs::path folder)
        : campus_(campus),
          walk_(walk),
          snapshot_renderer_(snapshot_renderer),
          output_(std::move(output)),
          folder_(std::move(folder)) {}

    /// Of every tick.
    void follow(const engine::TickRecord& record) {
        trail_.follow(record.avatar);
        for (const engine::Event& event : record.events) {
            if (event.kind == engine::EventKind::collision_enter) {
                touched_at_.push_back(record.avatar.position);
            }
        }
    }

    void draw(const engine::TickRecord& record, const std::optional<Vector3d>& contact,
              const std::string& caption) {
        ++moments_;
        const std::vector<Vector3d> path = trail_.path();
        render::SnapshotRequest request;
        request.camera = walk_.camera;
        request.camera.view = engine::FirstPersonView{};
        request.camera.width = kWidth;
        request.camera.height = kHeight;
        request.avatar = record.avatar;
        request.profile = walk_.avatar;
        request.open_popups = record.open_popups;
        request.caption = caption;
        request.minimap = false;  // the image from above says more
        save(snapshot_renderer_.draw(request), "eyes", "from the eyes", record.time);
        request.stride = trail_.stride();
        request.path = path;
        save(draw_beside(std::move(request), contact), "beside", "from beside", record.time);
        save(draw_map(campus_, snapshot_renderer_, {record.avatar, walk_.avatar, path, caption}, kWidth,
                      kHeight),
             "above", "from above", record.time);
    }

    const std::vector<engine::Artifact>& artifacts() const { return artifacts_; }

private:
    /// Third person, with what is in the way in the middle if anything is.
    render::Image draw_beside(render::SnapshotRequest request, const std::optional<Vector3d>& contact) {
        request.camera.view = engine::ThirdPersonView{};
        request.open_popups = {};  // their windows would cover half of it
        request.overlays.path = request.overlays.contacts = request.overlays.colliders = true;
        request.contacts = touched_at_;
        const Vector3d around = contact.value_or(request.avatar.position);
        request.outlined = collision::Aabb{around, around}.grown(kOutlined);
        if (!contact) {
            return snapshot_renderer_.draw(request);
        }
        const render::Viewpoint view = aim_at_contact(campus_, snapshot_renderer_, *contact, request);
        const render::Fonts fonts;
        const render::Canvas canvas(snapshot_renderer_.draw(request), fonts);
        if (const auto pixel = render::pixel_of(view, kWidth, kHeight, *contact)) {
            render::draw_ring(canvas, pixel->x(), pixel->y());
        }
        return canvas.image();
    }

    void save(const render::Image& image, const std::string& view, const std::string& from, double time) {
        const std::string number = moments_ == 1 ? "" : std::to_string(moments_) + "-";
        const fs::path file = folder_ / ("failure-" + number + view + ".png");
        render::write_png(image, output_ / file);
        artifacts_.push_back(
            {"failure at " + engine::fixed(time, 2) + " s " + from, file.generic_string(), "image/png"});
    }

    const scene::Campus& campus_;
    const engine::Walk& walk_;
    render::SnapshotRenderer& snapshot_renderer_;
    fs::path output_;
    fs::path folder_;
    std::size_t moments_ = 0;
    render::WalkTrail trail_;
    std::vector<Vector3d> touched_at_;  ///< foot points
    std::vector<engine::Artifact> artifacts_;
};

}  // namespace

std::vector<engine::Artifact> draw_failures(const scene::Campus& campus, const engine::Walk& walk,
                                            std::span<const engine::Failure> failures, const fs::path& output,
                                            const fs::path& folder, render::RendererStore& renderers,
                                            engine::RouteMemory* routes) {
    const std::vector<engine::Tick> moments = moments_of(failures);
    if (moments.empty()) {
        return {};
    }
    FailureImageRenderer images(campus, walk, renderers.of(campus, walk.light), output, folder);
    engine::Simulation simulation(campus, walk, routes);
    auto next = moments.begin();
    while (next != moments.end() && !simulation.finished()) {
        const engine::TickRecord& record = simulation.step();
        images.follow(record);
        // A failure that only the walk's end shows counts for its last tick, even if its own is later.
        if (record.tick == *next || (simulation.finished() && record.tick < *next)) {
            images.draw(record, contact_of(failures, *next), caption_of(failures, *next, record.time));
            ++next;
        }
    }
    return images.artifacts();
}

}  // namespace campuswalk::tools
