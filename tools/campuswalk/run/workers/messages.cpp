#include "tools/campuswalk/run/workers/messages.h"

#include <cstring>
#include <stdexcept>

namespace campuswalk::tools {

namespace {

constexpr std::size_t kHead = 1 + sizeof(std::uint32_t);

}  // namespace

std::string framed(Topic topic, std::string_view body) {
    std::string bytes(kHead, '\0');
    bytes[0] = static_cast<char>(topic);
    const auto length = static_cast<std::uint32_t>(body.size());
    std::memcpy(bytes.data() + 1, &length, sizeof(length));
    bytes.append(body);
    return bytes;
}

std::optional<Message> MessageReader::next() {
    const std::string_view left = std::string_view(bytes_).substr(read_);
    std::uint32_t length = 0;
    if (left.size() >= kHead) {
        std::memcpy(&length, left.data() + 1, sizeof(length));
    }
    if (left.size() < kHead || left.size() - kHead < length) {
        bytes_.erase(0, read_);
        read_ = 0;
        return std::nullopt;
    }
    const auto topic = static_cast<std::uint8_t>(left.front());
    if (topic > static_cast<std::uint8_t>(Topic::result)) {
        throw std::runtime_error("a worker sent what it can't mean");
    }
    read_ += kHead + length;
    return Message{static_cast<Topic>(topic), std::string(left.substr(kHead, length))};
}

}  // namespace campuswalk::tools
