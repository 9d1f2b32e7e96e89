#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "collision/world/obstacle.h"
#include "engine/observers/key_frames.h"
#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"
#include "scene/campus/campus.h"

namespace campuswalk::engine {

/// What a report needs to show a walk again (config/schema/recording.schema.json): the path as key frames
/// with straight lines between them, its steps, pop-ups and contacts as spans of ticks, and the text log. It
/// grows with what happens, hardly with the time that it takes.
class Recording final : public Observer {
public:
    /// `campus` must outlive it.
    Recording(LineSink sink, const scene::Campus& campus);

    void begin(const Walk& walk) override;
    void on_tick(const TickRecord& record) override;
    void end() override;

private:
    struct Step {
        std::size_t index = 0;  ///< in Walk::steps
        Tick from = 0;
    };
    struct Popup {
        std::string building;
        std::string title;
        std::string text;
        Tick from = 0;
        std::optional<Tick> to;
    };
    struct Contact {
        std::string object;
        Eigen::Vector3d point = Eigen::Vector3d::Zero();
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, towards the body; zero if it overlaps
        Tick from = 0;
        std::optional<Tick> to;
    };

    void add_key(const KeyFrame& key);
    void sample(const TickRecord& record);
    void follow_steps(const TickRecord& record);
    void note(const TickRecord& record, const Event& event);
    void open_popup(const TickRecord& record, const Event& event);
    void touch(const TickRecord& record, const std::string& object);
    template <typename Span>
    void close(std::vector<Span>& spans, std::string Span::*name, const Event& event);

    LineSink sink_;
    const scene::Campus& campus_;
    const Walk* walk_ = nullptr;
    std::uint32_t ignored_layers_ = 0;
    Tick next_ = 0;
    Tick last_ = 0;
    bool logged_ = false;  ///< a line

    KeyFrames frames_;
    KeyFrame previous_;
    std::size_t keys_ = 0;
    double yaw_ = 0.0;  ///< of the last sample, tenths of a degree, without jumps by a turn
    std::array<std::string, PathSample::kSize + 1> columns_;  ///< ticks, then the values: differences as text
    std::string cuts_;

    std::size_t steps_over_ = 0;
    bool in_step_ = false;
    std::vector<Step> steps_;
    std::vector<Popup> popups_;
    std::vector<Contact> contacts_;
    std::vector<collision::Obstacle> obstacles_;
};

}  // namespace campuswalk::engine
