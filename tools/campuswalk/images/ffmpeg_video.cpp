#include "tools/campuswalk/images/ffmpeg_video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/events/decimals.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

void write_all(int to, const std::vector<std::uint8_t>& bytes, bool& well) {
    std::size_t written = 0;
    while (well && written < bytes.size()) {
        const ssize_t now = write(to, bytes.data() + written, bytes.size() - written);
        well = now >= 0 || errno == EINTR;
        written += now > 0 ? static_cast<std::size_t>(now) : 0;
    }
}

/// What ffmpeg is told; H.264 halves the colours, so a side that is odd loses its last pixel.
std::vector<std::string> arguments(const engine::render::Image& image, double seconds_per_frame,
                                   const fs::path& file) {
    return {"ffmpeg",
            "-hide_banner",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgba",
            "-video_size",
            std::to_string(image.width) + "x" + std::to_string(image.height),
            "-framerate",
            engine::fixed(1.0 / seconds_per_frame, 6),
            "-i",
            "pipe:0",
            "-an",
            "-vf",
            "crop=trunc(iw/2)*2:trunc(ih/2)*2",
            "-c:v",
            "libx264",
            "-pix_fmt",
            "yuv420p",
            "-f",
            "mp4",
            fs::absolute(file).string()};
}

}  // namespace

bool has_ffmpeg() {
    const char* path = std::getenv("PATH");
    std::string_view folders = path != nullptr ? path : "";
    while (!folders.empty()) {
        const std::size_t colon = folders.find(':');
        const fs::path program = fs::path(folders.substr(0, colon)) / "ffmpeg";
        if (access(program.c_str(), X_OK) == 0) {
            return true;
        }
        folders.remove_prefix(colon == std::string_view::npos ? folders.size() : colon + 1);
    }
    return false;
}

FfmpegVideo::FfmpegVideo(fs::path file, double seconds_per_frame)
    : file_(std::move(file)), part_(file_), seconds_a_frame_(seconds_per_frame) {
    part_ += ".part";
}

FfmpegVideo::~FfmpegVideo() {
    if (process_ >= 0) {
        wait_for_end();
        std::error_code ignored;
        fs::remove(part_, ignored);
    }
}

void FfmpegVideo::start(const engine::render::Image& image) {
    fs::create_directories(file_.parent_path());
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        fail(std::generic_category().message(errno));
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
    std::vector<std::string> words = arguments(image, seconds_a_frame_, part_);
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    const int error = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    pipe_ = ends[1];
    if (error != 0) {
        close(std::exchange(pipe_, -1));
        process_ = -1;
        fail("ffmpeg can't be started: " + std::generic_category().message(error));
    }
}

void FfmpegVideo::add(const engine::render::Frame& frame) {
    if (process_ < 0) {
        start(frame.image);
    }
    bool well = true;
    write_all(pipe_, frame.image.rgba, well);
    if (!well) {
        wait_for_end();
        fail("ffmpeg ended before the walk did; see what it said");
    }
}

void FfmpegVideo::finish() {
    if (process_ < 0) {
        return;
    }
    if (!wait_for_end()) {
        fail("ffmpeg could not make it; see what it said");
    }
    std::error_code error;
    fs::rename(part_, file_, error);
    if (error) {
        fail(error.message());
    }
}

bool FfmpegVideo::wait_for_end() {
    close(std::exchange(pipe_, -1));
    int status = 0;
    pid_t ended = 0;
    do {
        ended = waitpid(process_, &status, 0);
    } while (ended < 0 && errno == EINTR);
    process_ = -1;
    return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void FfmpegVideo::fail(const std::string& why) const {
    std::error_code ignored;
    fs::remove(part_, ignored);
    throw std::runtime_error("can't write " + file_.string() + ": " + why);
}

}  // namespace campuswalk::tools
