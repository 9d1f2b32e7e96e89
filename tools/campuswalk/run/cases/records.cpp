#include "tools/campuswalk/run/cases/records.h"

#include <chrono>
#include <utility>

#include "engine/observers/cost_trace.h"
#include "engine/observers/recording.h"
#include "engine/observers/trajectory.h"
#include "scene/base/new_file.h"

namespace campuswalk::tools {

namespace {

template <typename Recorder>
std::unique_ptr<engine::Observer> make(engine::LineSink sink, const scene::Campus& /*campus*/) {
    return std::make_unique<Recorder>(std::move(sink));
}

std::unique_ptr<engine::Observer> make_recording(engine::LineSink sink, const scene::Campus& campus) {
    return std::make_unique<engine::Recording>(std::move(sink), campus);
}

/// A separate record, because the clock makes its bytes differ from run to run.
std::unique_ptr<engine::Observer> make_timed_trace(engine::LineSink sink, const scene::Campus& /*campus*/) {
    return std::make_unique<engine::CostTrace>(std::move(sink), [] {
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        return std::chrono::duration<double, std::micro>(now).count();
    });
}

}  // namespace

const std::vector<RecordKind>& record_kinds() {
    // A walk of which nothing else is kept needs no folder: to make one takes longer than to write its
    // recording.
    static const std::vector<RecordKind> kinds = {
        {kReportRecord, "recording", "recordings/", ".recording.json", "application/json", make_recording},
        {"csv", "csv", "", "/trajectory.csv", "text/csv", make<engine::TrajectoryCsv>},
        {"tum", "tum", "", "/trajectory.tum", "text/plain", make<engine::TrajectoryTum>},
        {"trace", "trace", "", "/trace.json", "application/json", make<engine::CostTrace>},
        {"timed-trace", "timed-trace", "", "/timed-trace.json", "application/json", make_timed_trace}};
    return kinds;
}

std::string record_file(const RecordKind& kind, const std::string& folder) {
    return kind.before + folder + kind.after;
}

std::string report_record_file(const std::string& folder) {
    return record_file(*std::ranges::find(record_kinds(), std::string_view(kReportRecord), &RecordKind::name),
                       folder);
}

Records::Records(const std::vector<std::string>& names, const scene::Campus& campus) {
    for (const RecordKind& kind : record_kinds()) {
        if (std::ranges::find(names, kind.name) == names.end()) {
            continue;
        }
        auto record = std::make_unique<Record>();
        record->kind = &kind;
        record->observer = kind.make(
            [&text = record->text](std::string_view line) {
                text.append(line);
                text += '\n';
            },
            campus);
        records_.push_back(std::move(record));
    }
}

std::vector<engine::Observer*> Records::observers() const {
    std::vector<engine::Observer*> observers;
    for (const auto& record : records_) {
        observers.push_back(record->observer.get());
    }
    return observers;
}

std::vector<engine::Artifact> Records::write(const std::filesystem::path& output,
                                             const std::string& folder) const {
    std::vector<engine::Artifact> written;
    for (const auto& record : records_) {
        const std::string path = record_file(*record->kind, folder);
        scene::write_new_file(output / path, record->text);
        written.push_back({record->kind->artifact, path, record->kind->media_type});
    }
    return written;
}

}  // namespace campuswalk::tools
