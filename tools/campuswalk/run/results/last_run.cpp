#include "tools/campuswalk/run/results/last_run.h"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <map>
#include <span>
#include <stdexcept>
#include <system_error>
#include <variant>

#include "engine/report/result_json.h"
#include "scene/base/content_hash.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/read_lines.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using engine::Outcome;

namespace {

constexpr const char* kHeaderKey = "campuswalk_last_run";
constexpr double kSyncEvery = 0.2;  // seconds: a sync takes a disk milliseconds, and a walk takes less

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

[[noreturn]] void refuse(const fs::path& file, int line, const std::string& why) {
    throw scene::InputError({file.generic_string(), line, line > 0 ? 1 : 0}, "bad-last-run",
                            why + "; delete the file and run everything again");
}

/// Reads every file once, and models not at all.
class PlanDigest {
public:
    void add(const Case& each) {
        hasher_.add_text(each.result.id);
        if (!each.walk) {
            return;
        }
        const engine::Walk& walk = each.walk->walk;
        add_contents(walk.mark.file);
        for (const engine::Step& step : walk.steps) {
            add_contents(std::visit([](const auto& any) { return any.mark.file; }, step));
        }
        add_contents(walk.campus);
        for (const scene::SceneFile& scene : each.walk->campus->description.scenes) {
            add_stamp(scene.path);
        }
        add_avatar(walk.avatar);
        hasher_.add_number(walk.timeout.value_or(-1.0));
    }

    std::string text() const { return to_string(hasher_.result()); }

private:
    void add_contents(const fs::path& file) {
        const auto [known, is_new] = known_.try_emplace(file.generic_string());
        if (is_new) {
            const std::string contents = read_bytes(file);
            known->second = scene::hash_of(std::as_bytes(std::span(contents)));
        }
        hasher_.add_hash(known->second);
    }

    void add_stamp(const fs::path& file) {
        std::error_code ignored;
        hasher_.add_number(std::uint64_t{fs::file_size(file, ignored)});
        hasher_.add_number(
            static_cast<std::uint64_t>(fs::last_write_time(file, ignored).time_since_epoch().count()));
    }

    void add_avatar(const engine::AvatarProfile& avatar) {
        for (const double number : {avatar.height, avatar.radius, avatar.eye_height, avatar.speed,
                                    avatar.run_speed.value_or(-1.0), avatar.step_height, avatar.max_slope,
                                    avatar.skin_width, avatar.turn_speed, avatar.look_distance}) {
            hasher_.add_number(number);
        }
        for (const std::string& layer : avatar.ignore_layers) {
            hasher_.add_text(layer);
        }
    }

    scene::ContentHasher hasher_;
    std::map<std::string, scene::ContentHash> known_;
};

}  // namespace

fs::path last_run_file(const fs::path& output) {
    return output / "last-run.jsonl";
}

std::optional<LastRun> read_last_run(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) {
        return std::nullopt;
    }
    const std::string bytes = read_bytes(file);
    LastRun run;
    int number = 0;
    for (std::size_t start = 0; start < bytes.size();) {
        const std::size_t end = bytes.find('\n', start);
        if (end == std::string::npos) {
            break;  // the line was cut short
        }
        const std::string line = bytes.substr(start, end - start);
        ++number;
        try {
            if (number == 1) {
                run.plan = Json::parse(line).at(kHeaderKey).get<std::string>();
            } else {
                run.results.push_back(engine::result_from_json_line(line));
            }
        } catch (const std::exception& error) {
            refuse(file, number, error.what());
        }
        start = end + 1;
        run.whole_bytes = start;
    }
    if (number == 0) {
        return std::nullopt;
    }
    return run;
}

std::set<std::string> failed_ids(const LastRun& run) {
    std::set<std::string> ids;
    for (const engine::WalkResult& result : run.results) {
        if (result.outcome != Outcome::passed && result.outcome != Outcome::skipped) {
            ids.insert(result.id);
        } else {
            ids.erase(result.id);  // it passed when a resumed run played it again
        }
    }
    return ids;
}

std::string fingerprint(const Plan& plan) {
    PlanDigest digest;
    for (const Case& each : plan.cases) {
        digest.add(each);
    }
    return digest.text();
}

LastRunWriter::LastRunWriter(const fs::path& file, const std::string& plan) : name_(file) {
    std::error_code ignored;
    if (!file.parent_path().empty()) {
        fs::create_directories(file.parent_path(), ignored);
    }
    file_.reset(std::fopen(file.c_str(), "wb"));
    write_line(json_text({{kHeaderKey, plan}}));
    sync();
}

LastRunWriter::LastRunWriter(const fs::path& file, const LastRun& run) : name_(file) {
    fs::resize_file(file, run.whole_bytes);
    file_.reset(std::fopen(file.c_str(), "ab"));
}

void LastRunWriter::add(const std::string& result_line) {
    write_line(result_line);
    sync_if_due();
}

void LastRunWriter::write_line(const std::string& line) {
    const bool written = file_ && std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size() &&
                         std::fputc('\n', file_.get()) != EOF && std::fflush(file_.get()) == 0;
    if (!written) {
        throw std::runtime_error("results can't be saved in " + name_.generic_string() + ": " +
                                 std::generic_category().message(errno));
    }
    unsynced_ = true;
}

void LastRunWriter::sync_if_due() {
    if (unsynced_ && seconds_now() - synced_at_ > kSyncEvery) {
        sync();
    }
}

void LastRunWriter::sync() {
    fdatasync(fileno(file_.get()));  // some file systems can't sync; then results are as safe as without it
    unsynced_ = false;
    synced_at_ = seconds_now();
}

void LastRunWriter::close() {
    if (unsynced_) {
        sync();
    }
    file_.reset();
}

}  // namespace campuswalk::tools
