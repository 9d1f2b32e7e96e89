#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/html_report/details_chunks.h"
#include "engine/html_report/html_page.h"
#include "engine/html_report/recorded_path.h"
#include "engine/report/reporter.h"
#include "scene/export/webp_image.h"

namespace campuswalk::engine {

/// A campus as a report shows it.
struct ReportCampus {
    std::string entry;   ///< see campus_entry
    std::string glb;     ///< see scene::write_glb, as Gzip packs it; empty: only its objects' boxes are shown
    double error = 0.0;  ///< of the glb, metres; 0: exact
};

/// Reads a file of a run; none if it isn't there or may not be read.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

/// Calls `visit` for each of the pictures at `paths` that can be read, by their indices in ascending order.
using ImageReader =
    std::function<void(const FileReader& read, const std::vector<std::string>& paths,
                       const std::function<void(std::size_t index, const scene::PixelView& pixels)>& visit)>;

/// Another run, to compare with.
struct ComparedRun {
    std::string name;
    std::function<std::optional<WalkResult>(const std::string& id)> find;
    /// Calls `visit` for each result.
    std::function<void(const std::function<void(const WalkResult&)>& visit)> for_each;
    FileReader read_artifact;
};

/// What a report is made of besides results.
struct HtmlInputs {
    ViewerBundle viewer;
    std::string title = "campuswalk";
    std::string generator = "campuswalk";
    std::string command;  ///< that made the run; may be empty
    FileReader read_artifact;
    ImageReader read_images;
    FileReader read_source;  ///< walk files, to show the lines that failures are about
    /// The campus file of a walk that has no recording; empty if it can't be told.
    std::function<std::string(const WalkResult& result)> campus_file_of;
    std::function<std::optional<ReportCampus>(const std::string& campus_file)> find_campus;
    std::optional<ComparedRun> against;
    std::string findings;  ///< of explore: a JSON list, each with the name of its "campus"; empty: none
    std::vector<std::string> problems;  ///< why results may be missing
    std::string start;  ///< where the run was started, as seen from the repository's root: see report_paths.h
};

/// Writes a report that shows walks in three dimensions, as one HTML file. Needs the walks' recordings
/// (engine/observers/recording.h); without them it shows results only. Memory: a row of the index for each
/// walk.
class HtmlReporter final : public Reporter {
public:
    HtmlReporter(TextSink sink, HtmlInputs inputs);

    void begin(const RunPlan& plan) override;
    void result(const WalkResult& result) override;
    void end(const ResultSequence& results) override;

private:
    struct Details {
        std::string line;
        std::string row;
        std::optional<RecordedPath> path;
    };

    Details details_of(const WalkResult& result, const FileReader& read_artifact);
    std::string images_of(const WalkResult& result, const FileReader& read_artifact,
                          std::ptrdiff_t& thumbnail);
    std::string source_of(const WalkResult& result) const;
    std::ptrdiff_t campus_of(const WalkResult& result, const std::optional<RecordedPath>& path);
    void add_campus(const ReportCampus& campus);
    void compare(const WalkResult& result, const std::optional<RecordedPath>& path);
    void add_compared(const WalkResult& other, std::size_t index, const std::optional<RecordedPath>& path);
    void add_unmatched();
    std::string against_json() const;
    std::string findings_json() const;

    HtmlInputs inputs_;
    HtmlPage page_;
    DetailsChunks details_;
    std::size_t planned_ = 0;
    std::size_t walks_ = 0;
    std::string rows_;                                ///< of the index
    std::string against_rows_;                        ///< likewise, of the other run
    std::map<std::string, std::ptrdiff_t> campuses_;  ///< index by file; -1: it can't be shown
    std::map<std::string, std::ptrdiff_t> names_;     ///< of campuses
    std::vector<std::string> campus_entries_;
    std::vector<std::uint64_t> seen_;  ///< hashes of ids, to find what only the other run has
};

}  // namespace campuswalk::engine
