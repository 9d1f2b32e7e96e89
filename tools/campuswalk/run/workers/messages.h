#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace campuswalk::tools {

/// What a worker says about the case it plays.
enum class Topic : std::uint8_t {
    log,     ///< lines of the text log
    events,  ///< lines of the log as JSON
    place,   ///< the walk's time in seconds, for people to see
    frame,   ///< what FrameSharing::take gives, from one that helps to draw
    result,  ///< the last: engine::to_json_line, or of one that helps to draw what went wrong
};

struct Message {
    Topic topic = Topic::log;
    std::string body;
};

/// As bytes: the topic, the length, the body.
std::string framed(Topic topic, std::string_view body);

/// Puts messages together again from whatever pieces a pipe gives.
class MessageReader {
public:
    void add(std::string_view bytes) { bytes_.append(bytes); }
    /// The next one that is whole; nullopt until more has come. Throws std::runtime_error for what no worker
    /// sends.
    std::optional<Message> next();

private:
    std::string bytes_;
    std::size_t read_ = 0;
};

}  // namespace campuswalk::tools
