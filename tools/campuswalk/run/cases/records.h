#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/observers/line_sink.h"
#include "engine/record/observer.h"
#include "engine/report/walk_result.h"
#include "scene/campus/campus.h"

namespace campuswalk::tools {

/// What can be recorded of every tick of a walk, as a file.
struct RecordKind {
    const char* name = "";      ///< as `run --record` takes it
    const char* artifact = "";  ///< its name in results
    const char* before = "";    ///< what its path has before the walk's folder
    const char* after = "";     ///< and after it
    const char* media_type = "";
    std::unique_ptr<engine::Observer> (*make)(engine::LineSink, const scene::Campus&) = nullptr;
};

/// The one that reports show walks from.
inline constexpr const char* kReportRecord = "report";
/// Whether it is among the names of records.
inline bool records_for_reports(const std::vector<std::string>& names) {
    return std::ranges::find(names, kReportRecord) != names.end();
}

const std::vector<RecordKind>& record_kinds();

/// Below the run's output folder, for the walk with this folder.
std::string record_file(const RecordKind& kind, const std::string& folder);
/// Where it keeps what reports show walks from.
std::string report_record_file(const std::string& folder);

/// The records of one walk, which are written when it has ended.
class Records {
public:
    /// `names` are of record_kinds(); the campus must outlive this.
    Records(const std::vector<std::string>& names, const scene::Campus& campus);

    /// They live as long as this.
    std::vector<engine::Observer*> observers() const;
    /// Writes OUTPUT/record_file for each record and returns which. Throws std::runtime_error.
    std::vector<engine::Artifact> write(const std::filesystem::path& output, const std::string& folder) const;

private:
    struct Record {
        const RecordKind* kind = nullptr;
        std::string text;
        std::unique_ptr<engine::Observer> observer;
    };
    std::vector<std::unique_ptr<Record>> records_;
};

}  // namespace campuswalk::tools
