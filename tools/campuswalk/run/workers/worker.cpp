#include "tools/campuswalk/run/workers/worker.h"

#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace campuswalk::tools {

namespace {

constexpr std::size_t kHead = 1 + sizeof(std::uint32_t);

/// The next task; nullopt when there are no more.
std::optional<std::size_t> read_task(int from) {
    std::uint64_t task = 0;
    // So few bytes arrive at once or not at all.
    const bool whole = scene::read_some(from, std::as_writable_bytes(std::span(&task, 1))) == sizeof(task);
    return whole ? std::optional<std::size_t>(task) : std::nullopt;
}

/// A worker's whole life, in its process.
[[noreturn]] void serve(const StartWork& start, int tasks, int answers) {
    const Send send = [&](Topic topic, std::string_view body) {
        if (!scene::write_all(answers, framed(topic, body))) {
            _exit(1);  // nobody reads any more
        }
    };
    const Work work = start();
    while (const std::optional<std::size_t> task = read_task(tasks)) {
        work(*task, send);
    }
    _exit(0);  // skips freeing the memory
}

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

Worker::Worker(const StartWork& start, const std::vector<Worker>& others) {
    try {
        scene::Pipe tasks = scene::make_pipe();
        scene::Pipe answers = scene::make_pipe();
        process_ = scene::fork_process([&] {
            tasks.writing.close();
            answers.reading.close();
            for (const Worker& other : others) {  // or their readers would never see the end
                ::close(other.tasks_.number());
                ::close(other.answers_.number());
            }
            serve(start, tasks.reading.number(), answers.writing.number());
        });
        tasks_ = std::move(tasks.writing);
        answers_ = std::move(answers.reading);
    } catch (const std::system_error& error) {
        throw std::runtime_error("no worker can be started: " + error.code().message());
    }
}

Worker::~Worker() {
    if (task_) {
        send_signal(SIGKILL);
    }
    wait();
}

void Worker::give(std::size_t task) {
    task_ = task;
    const std::uint64_t number = task;
    static_cast<void>(scene::write_all(tasks_.number(), std::as_bytes(std::span(&number, 1))));
}

bool Worker::read() {
    std::array<char, 1 << 16> bytes{};
    const std::size_t got = scene::read_some(answers_.number(), std::as_writable_bytes(std::span(bytes)));
    reader_.add({bytes.data(), got});
    return got > 0;
}

std::optional<Message> Worker::next_message() {
    std::optional<Message> message = reader_.next();
    if (message && message->topic == Topic::result) {
        task_.reset();
    }
    return message;
}

Message Worker::wait_for_message(std::string_view what_for) {
    while (true) {
        if (std::optional<Message> message = next_message()) {
            return std::move(*message);
        }
        if (!read()) {
            throw std::runtime_error("a process that " + std::string(what_for) +
                                     " is gone: " + scene::to_string(wait()));
        }
    }
}

scene::ExitStatus Worker::wait() {
    task_.reset();
    tasks_.close();
    answers_.close();
    return process_.wait();
}

}  // namespace campuswalk::tools
