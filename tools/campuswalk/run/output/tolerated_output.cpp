#include "tools/campuswalk/run/output/tolerated_output.h"

#include <filesystem>
#include <string>

#include "tools/campuswalk/run/cases/records.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

class Tolerated {
public:
    explicit Tolerated(const fs::path& output) : output_(output) {}

    void add_case(const std::string& folder) {
        tolerance_.paths.emplace_back(folder);
        tolerance_.paths.emplace_back(report_record_file(folder));
    }
    void add_file(const fs::path& file) { tolerance_.paths.push_back(file.lexically_relative(output_)); }
    void add(const fs::path& path) { tolerance_.paths.push_back(path); }

    OutputFolder::Tolerance result() const { return tolerance_; }

private:
    const fs::path& output_;
    OutputFolder::Tolerance tolerance_;
};

/// The folder in the output folder where the tasks of a job keep their results; empty for other runs, which
/// keep them in the output folder itself.
fs::path folder_of_tasks(const RunSettings& settings) {
    const fs::path saved = settings.saved.lexically_relative(settings.output);
    return saved.has_parent_path() && *saved.begin() != ".." ? *saved.begin() : fs::path();
}

}  // namespace

OutputFolder::Tolerance tolerated_output(const RunSettings& settings, const Plan& plan, bool continues) {
    if (!settings.ci) {
        return {.all = true, .paths = {}};
    }
    Tolerated tolerated(settings.output);
    if (continues) {
        for (const Case& each : plan.cases) {
            tolerated.add_case(each.folder);
        }
        for (const ReportTarget& target : settings.reports) {
            if (target.file) {
                tolerated.add_file(*target.file);
            }
        }
        tolerated.add_file(settings.saved);
        tolerated.add(kBundleFolder);
    }
    if (const fs::path tasks = folder_of_tasks(settings);
        !tasks.empty()) {  // whose submission has looked there
        for (const std::string& folder : plan.other_folders) {
            tolerated.add_case(folder);
        }
        tolerated.add(tasks);
        tolerated.add(kBundleFolder);
    }
    return tolerated.result();
}

}  // namespace campuswalk::tools
