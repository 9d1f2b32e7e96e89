#include "tools/campuswalk/run/watch.h"

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

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "config/loader/load_run.h"
#include "config/loader/overrides.h"
#include "scene/base/diagnostic.h"
#include "scene/process/child_process.h"
#include "scene/process/pipe.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/print.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/loading/walk_loader.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/workers/interrupt.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// Which files the walks of a run depend on, as far as reading the walks shows.
class Dependencies {
public:
    explicit Dependencies(const RunSettings& settings) {
        std::error_code ignored;
        output_ = fs::absolute(settings.output, ignored);
        for (const fs::path& path : settings.paths) {
            fs::is_directory(path, ignored) ? add_folders_below(path) : add_folder(path.parent_path());
        }
        if (!settings.config.empty()) {
            add_folder(settings.config.parent_path());
        }
        WalkLoader loader;
        for (const fs::path& walk : find_walks(settings.paths)) {
            for (const char* profiles : {"avatars", "config/avatars", "lights", "config/lights"}) {
                add_folder(walk.parent_path() / profiles);
            }
            for (const config::ProjectConfig& project : settings.projects) {
                add_walk(loader, walk, project.overrides);
            }
        }
    }

    /// The folders of these files, and those that are searched for walks.
    const std::set<std::filesystem::path>& folders() const { return folders_; }

    /// The walks to play again when files have changed; none if it may be any walk: after a file was removed,
    /// or if an avatar that may hide another one or walks.config.yaml has changed.
    std::vector<fs::path> walks_of(const std::set<fs::path>& changed) const {
        std::error_code ignored;
        Paths walks = walks_with_errors_;
        for (const fs::path& file : changed) {
            Paths users;
            if (const auto known = walks_by_file_.find(file); known != walks_by_file_.end()) {
                users = known->second;
            } else if (file.string().ends_with(config::kWalkSuffix)) {
                users = {file};
            } else if (file.extension() != ".yaml") {
                users = walks_of_model_at(file);
            }
            if (users.empty() || !fs::exists(file, ignored)) {
                return {};
            }
            walks.insert(users.begin(), users.end());
        }
        return {walks.begin(), walks.end()};
    }

private:
    using Paths = std::set<std::filesystem::path>;

    void add_folder(const fs::path& folder) {
        std::error_code ignored;
        const fs::path there = folder.empty() ? fs::path(".") : folder.lexically_normal();
        if (fs::is_directory(there, ignored)) {
            folders_.insert(there);
        }
    }

    void add_folders_below(const fs::path& folder) {
        std::error_code ignored;
        add_folder(folder);
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
            const std::string name = entry.path().filename().string();
            const bool is_output =
                name.ends_with("-snapshots") || fs::absolute(entry.path(), ignored) == output_;
            if (entry.is_directory(ignored) && !entry.is_symlink(ignored) && name.front() != '.' &&
                !is_output) {
                add_folders_below(entry.path());
            }
        }
    }

    void add_walk(WalkLoader& loader, const fs::path& walk, const config::Overrides& overrides) {
        add_dependency(walk, walk);
        try {
            const config::Run run = loader.read(walk, overrides);
            add_dependency(walk, run.walk.campus);
            for (const fs::path& profile : run.profiles) {
                add_dependency(walk, profile);
            }
            for (const scene::SceneFile& scene : run.campus->scenes) {
                add_folder(scene.path.parent_path());
                walks_by_model_folder_[scene.path.lexically_normal().parent_path()].insert(walk);
            }
            for (const fs::path& file : run.walk.included) {
                add_dependency(walk, file);
            }
        } catch (const scene::InputError&) {
            walks_with_errors_.insert(walk);  // the run reports the errors
        }
    }

    void add_dependency(const fs::path& walk, const fs::path& file) {
        add_folder(file.parent_path());
        walks_by_file_[file.lexically_normal()].insert(walk);
    }

    /// The walks that use the models in the nearest folder above the file that contains models.
    Paths walks_of_model_at(const fs::path& file) const {
        for (fs::path folder = file.parent_path();; folder = folder.parent_path()) {
            if (const auto known = walks_by_model_folder_.find(folder);
                known != walks_by_model_folder_.end()) {
                return known->second;
            }
            if (folder == folder.parent_path()) {
                return {};
            }
        }
    }

    std::filesystem::path output_;
    Paths folders_;
    std::map<std::filesystem::path, Paths> walks_by_file_;
    std::map<std::filesystem::path, Paths> walks_by_model_folder_;  ///< also for textures and buffers
    Paths walks_with_errors_;                                       ///< which may depend on any file
};

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
