#include "tools/campuswalk/run/workers/worker.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace campuswalk::tools {

namespace {

bool write_all(int to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(to, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR) {
            return false;
        }
        bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
    }
    return true;
}

/// The next task; nullopt when there are no more.
std::optional<std::size_t> read_task(int from) {
    std::uint64_t task = 0;
    ssize_t got = 0;
    do {
        got = ::read(from, &task, sizeof(task));  // so few bytes come at once or not at all
    } while (got < 0 && errno == EINTR);
    return got == static_cast<ssize_t>(sizeof(task)) ? std::optional<std::size_t>(task) : std::nullopt;
}

struct Pipe {
    Descriptor end;    // to read from
    Descriptor start;  // to write to
};

Pipe make_pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {  // ffmpeg has no business with it
        throw std::runtime_error("no worker can be started: " + std::generic_category().message(errno));
    }
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

}  // namespace

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
    if (this != &other) {
        close();
        number_ = std::exchange(other.number_, -1);
    }
    return *this;
}

void Descriptor::close() {
    if (number_ >= 0) {
        ::close(std::exchange(number_, -1));
    }
}

Worker::Worker(const Work& work, const std::vector<Worker>& others) {
    Pipe tasks = make_pipe();
    Pipe answers = make_pipe();
    const pid_t parent = getpid();
    process_ = fork();
    if (process_ < 0) {
        throw std::runtime_error("no worker can be started: " + std::generic_category().message(errno));
    }
    if (process_ == 0) {
        tasks.start.close();
        answers.end.close();
        for (const Worker& other : others) {  // or their ends would never show
            ::close(other.tasks_.number());
            ::close(other.answers_.number());
        }
        serve(work, tasks.end.number(), answers.start.number(), parent);
    }
    tasks_ = std::move(tasks.start);
    answers_ = std::move(answers.end);
}

void Worker::serve(const Work& work, int tasks, int answers, pid_t parent) const {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        _exit(1);  // it died before it could be asked to take this one along
    }
    const Say say = [&](Topic topic, std::string_view body) {
        if (!write_all(answers, framed(topic, body))) {
            _exit(1);  // nobody listens any more
        }
    };
    while (const std::optional<std::size_t> task = read_task(tasks)) {
        work(*task, say);
    }
    _exit(0);
}

Worker::~Worker() {
    end();
}

Worker::Worker(Worker&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      tasks_(std::move(other.tasks_)),
      answers_(std::move(other.answers_)),
      reader_(std::move(other.reader_)),
      place_(other.place_),
      deadline_(other.deadline_) {}

Worker& Worker::operator=(Worker&& other) noexcept {
    std::swap(process_, other.process_);
    std::swap(tasks_, other.tasks_);
    std::swap(answers_, other.answers_);
    std::swap(reader_, other.reader_);
    std::swap(place_, other.place_);
    std::swap(deadline_, other.deadline_);
    return *this;
}

void Worker::end() {
    if (process_ < 0) {
        return;
    }
    if (place_) {
        send_signal(SIGKILL);
    }
    tasks_.close();
    static_cast<void>(exit_reason());
}

void Worker::give(std::size_t task, std::size_t place,
                  std::optional<std::chrono::steady_clock::time_point> deadline) {
    place_ = place;
    deadline_ = deadline;
    const std::uint64_t number = task;
    std::array<char, sizeof(number)> bytes{};
    std::memcpy(bytes.data(), &number, sizeof(number));
    static_cast<void>(write_all(tasks_.number(), {bytes.data(), bytes.size()}));
}

bool Worker::read() {
    std::array<char, 1 << 16> bytes{};
    const ssize_t got = ::read(answers_.number(), bytes.data(), bytes.size());
    if (got > 0) {
        reader_.add({bytes.data(), static_cast<std::size_t>(got)});
    }
    return got > 0 || (got < 0 && errno == EINTR);
}

Message Worker::wait_for_message(std::string_view what_for) {
    while (true) {
        if (std::optional<Message> message = next_message()) {
            return std::move(*message);
        }
        if (!read()) {
            forget_task();
            hang_up();
            throw std::runtime_error("a process that " + std::string(what_for) +
                                     " is gone: " + exit_reason());
        }
    }
}

void Worker::send_signal(int signal) const {
    if (process_ > 0) {
        kill(process_, signal);
    }
}

void Worker::hang_up() {
    tasks_.close();
    answers_.close();
}

std::string Worker::exit_reason() {
    if (process_ < 0) {
        return "it has been waited for";
    }
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return "it was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")";
    }
    return "it ended with code " + std::to_string(WEXITSTATUS(status));
}

}  // namespace campuswalk::tools
