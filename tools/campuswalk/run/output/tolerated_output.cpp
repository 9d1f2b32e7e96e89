#include "tools/campuswalk/run/output/tolerated_output.h"

#include <filesystem>
#include <string>

#include "tools/campuswalk/run/cases/records.h"
#include "tools/campuswalk/run/output/job_folder.h"

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
    void add_temporaries() { tolerance_.temporaries = true; }
    void add(const fs::path& path) { tolerance_.paths.push_back(path); }

    OutputFolder::Tolerance result() const { return tolerance_; }

private:
    const fs::path& output_;
    OutputFolder::Tolerance tolerance_;
};

/// Whether this is a task of a job on a cluster, whose script has it save its results in the job's folder.
bool is_task(const RunSettings& settings) {
    return settings.saved.parent_path() == job_folder(settings.output).saved();
}

}  // namespace

OutputFolder::Tolerance tolerated_output(const RunSettings& settings, const Plan& plan, bool continues) {
    if (!settings.ci) {
        return {.all = true, .temporaries = true, .paths = {}};
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
        tolerated.add_temporaries();
        tolerated.add(kBundleFolder);
    }
    if (is_task(settings)) {  // its submission has looked through the folder, and other tasks write there
        for (const std::string& folder : plan.other_folders) {
            tolerated.add_case(folder);
        }
        tolerated.add_file(job_folder(settings.output).root);
        tolerated.add_temporaries();
        tolerated.add(kBundleFolder);
    }
    return tolerated.result();
}

}  // namespace campuswalk::tools
