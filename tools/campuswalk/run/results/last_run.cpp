#include "tools/campuswalk/run/results/last_run.h"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/report/result_json.h"
#include "scene/base/atomic_file.h"
#include "scene/base/diagnostic.h"
#include "scene/base/json_limits.h"
#include "tools/campuswalk/base/file_lines.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/run/plan/case_times.h"
#include "tools/campuswalk/run/results/signed_line.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using engine::Outcome;

namespace {

constexpr const char* kHeaderKey = "campuswalk_last_run";
const std::string kTimeBegin = std::string("{\"") + kMicroseconds + "\":";
constexpr double kSyncEvery = 0.2;  // seconds: a sync takes a disk milliseconds, and a walk takes less

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

[[noreturn]] void refuse(const fs::path& file, int line, const std::string& why) {
    throw scene::InputError({file.generic_string(), line, line > 0 ? 1 : 0}, "bad-last-run",
                            why + "; delete the file and run everything again");
}

/// Besides the result, a line says how long the case took: equal results have equal lines elsewhere.
std::string with_time(const std::string& result_line, std::uint64_t microseconds) {
    return kTimeBegin + std::to_string(microseconds) + "," + result_line.substr(1);
}

/// The result's own line.
std::string without_time(const std::string& object) {
    const std::size_t end = object.find_first_not_of("0123456789", kTimeBegin.size());
    const bool timed = object.starts_with(kTimeBegin) && end != std::string::npos && object[end] == ',';
    return timed ? "{" + object.substr(end + 1) : object;
}

std::string plan_of(const std::string& header) {
    const Json json = scene::why_too_complex(header).empty() ? Json::parse(header, nullptr, false) : Json();
    if (!json.is_object() || !json.contains(kHeaderKey) || !json.at(kHeaderKey).is_string()) {
        throw std::runtime_error("it doesn't begin as what a run has saved");
    }
    return json.at(kHeaderKey).get<std::string>();
}

}  // namespace

std::optional<LastRun> read_last_run(const fs::path& file, const std::string& key) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) {
        return std::nullopt;
    }
    FileLines lines(file);
    LastRun run;
    run.authentic = true;
    while (const auto line = lines.next()) {  // a last one that was cut short isn't a result
        try {
            const std::string object = unsigned_line(*line);
            if (lines.number() == 1) {
                run.plan = plan_of(object);
            } else {
                run.results.push_back(engine::result_from_json_line(without_time(object)));
            }
            run.authentic = run.authentic && is_authentic(*line, run.plan, key);
        } catch (const std::exception& error) {
            refuse(file, lines.number(), error.what());
        }
    }
    run.whole_bytes = lines.end();
    return lines.number() > 0 ? std::optional(std::move(run)) : std::nullopt;
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

LastRunWriter::LastRunWriter(const fs::path& file, const std::string& plan, std::string key)
    : name_(file), plan_(plan), key_(std::move(key)) {
    try {
        file_ = scene::open_new_file(file);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error("results can't be saved: " + std::string(error.what()));
    }
    write_line(json_text({{kHeaderKey, plan}}));
    sync();
}

LastRunWriter::LastRunWriter(const fs::path& file, const LastRun& run, std::string key)
    : name_(file), plan_(run.plan), key_(std::move(key)) {
    // A file that is there already may have another name elsewhere.
    scene::write_file_atomically(file, std::string_view(read_bytes(file)).substr(0, run.whole_bytes));
    file_.reset(std::fopen(file.c_str(), "abe"));
}

void LastRunWriter::add(const std::string& result_line, std::optional<std::uint64_t> microseconds) {
    write_line(microseconds ? with_time(result_line, *microseconds) : result_line);
    sync_if_due();
}

void LastRunWriter::write_line(const std::string& object) {
    const std::string line = signed_line(object, plan_, key_);
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
