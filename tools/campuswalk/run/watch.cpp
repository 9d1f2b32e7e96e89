#include "tools/campuswalk/run/watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

#include "scene/process/child_process.h"
#include "scene/process/pipe.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/run/plan/dependencies.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr int kPollInterval = 100;  // milliseconds; editors write a file in several steps
constexpr std::uint32_t kChanges = IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE | IN_CREATE;

bool is_watched(const std::string& name) {
    static constexpr std::array kExtensions = {".yaml", ".obj", ".mtl", ".glb", ".gltf", ".bin",
                                               ".fbx",  ".dae", ".png", ".jpg", ".jpeg", ".ifc"};
    const std::string extension = fs::path(name).extension().string();
    return std::ranges::find(kExtensions, extension) != kExtensions.end();
}

class FileWatch {
public:
    explicit FileWatch(const std::set<fs::path>& folders)
        : changes_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        if (changes_.number() < 0) {
            throw std::runtime_error("files can't be watched: " + std::generic_category().message(errno));
        }
        for (const fs::path& folder : folders) {
            const int watch = inotify_add_watch(changes_.number(), folder.c_str(), kChanges);
            if (watch < 0) {
                throw std::runtime_error("'" + folder.string() +
                                         "' can't be watched: " + std::generic_category().message(errno));
            }
            folders_[watch] = folder;
        }
    }

    /// The files that changed, once no more changes come; nullopt when interrupted.
    std::optional<std::set<fs::path>> wait() {
        std::set<fs::path> changed;
        while (!interrupted()) {
            pollfd pipe{changes_.number(), POLLIN, 0};
            if (poll(&pipe, 1, kPollInterval) > 0) {
                read_events(changed);
            } else if (!changed.empty()) {
                return changed;
            }
        }
        return std::nullopt;
    }

private:
    void read_events(std::set<fs::path>& changed) {
        alignas(inotify_event) std::array<char, 1 << 14> bytes{};
        const ssize_t got = read(changes_.number(), bytes.data(), bytes.size());
        for (ssize_t at = 0; at < got;) {
            inotify_event event{};
            std::memcpy(&event, bytes.data() + at, sizeof(event));
            const char* name = bytes.data() + at + static_cast<ssize_t>(sizeof(event));
            if (event.len > 0 && is_watched(name)) {
                changed.insert((folders_[event.wd] / name).lexically_normal());
            }
            at += static_cast<ssize_t>(sizeof(event) + event.len);
        }
    }

    scene::Descriptor changes_;
    std::map<int, fs::path> folders_;
};

void run_in_child(const std::function<int(const std::vector<fs::path>&)>& run,
                  const std::vector<fs::path>& changed) {
    std::fflush(stdout);
    scene::ChildProcess child = scene::fork_process([&] {
        report_exceptions([&] { return run(changed); });
        std::fflush(stdout);
    });
    bool signal_sent = false;
    while (!child.ends_within(std::chrono::milliseconds(kPollInterval / 5))) {
        if (interrupted() && !signal_sent) {
            child.send_signal(SIGINT);
            signal_sent = true;
        }
    }
}

}  // namespace

int watch_and_run(const RunSettings& settings, const std::function<int(const std::vector<fs::path>&)>& run) {
    watch_for_interrupts();
    std::vector<fs::path> changed;
    while (true) {
        const Dependencies dependencies(settings);
        FileWatch watch(dependencies.folders());  // before the run: what changes during it counts
        run_in_child(run, changed);
        if (!interrupted()) {
            print_error_line("watching; Ctrl-C ends it");
        }
        const auto files = watch.wait();
        if (!files) {
            return kInterrupted;
        }
        changed = dependencies.walks_of(*files);
    }
}

}  // namespace campuswalk::tools
