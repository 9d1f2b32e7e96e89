#include "tools/campuswalk/validate/check_config.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "config/loader/walks_config.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/run/plan/find_walks.h"
#include "tools/campuswalk/run/plan/plan.h"
#include "tools/campuswalk/run/plan/run_settings.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

using config::ProjectConfig;
using config::WalksConfig;
using scene::Diagnostic;

namespace {

class ConfigCheck {
public:
    ConfigCheck(WalkLoader& loader, const WalksConfig& config, const WalkLoader::Warn& warn)
        : loader_(loader), config_(config), warn_(warn) {}

    void run() {
        for (const config::ConfiguredReporter& reporter : config_.reporters) {
            note([&] { check_reporter(reporter.name, reporter.mark); });
        }
        const std::vector<fs::path> walks = walk_files();
        for (const ProjectConfig& project : config_.projects) {
            check(project, walks);
        }
        warn_of_walks();
        found_.throw_if_errors();
    }

private:
    template <typename Check>
    bool note(const Check& check) {
        try {
            check();
            return true;
        } catch (const scene::InputError& error) {
            found_.append(error.diagnostics());
            return false;
        }
    }

    std::vector<fs::path> walk_files() {
        std::vector<fs::path> existing;
        for (const config::MarkedPath& walks : config_.walks) {
            std::error_code ignored;
            if (fs::exists(walks.path, ignored)) {
                existing.push_back(as_seen_from_here(walks.path));
            } else {
                found_.error(walks.mark, "missing-file",
                             "there is no '" + walks.path.generic_string() + "'; check the path");
            }
        }
        if (config_.walks.empty()) {
            existing.push_back(as_seen_from_here(config_.file.parent_path() / "."));
        }
        std::vector<fs::path> files;
        note([&] { files = find_walks(existing); });
        return files;
    }

    void check(const ProjectConfig& project, const std::vector<fs::path>& walks) {
        std::optional<Selector> selector;
        const bool selector_valid = note([&] { selector = selector_of(project); });
        const bool overrides_valid = note([&] { loader_.check(project.overrides); });
        if (!selector_valid || !overrides_valid) {
            return;  // every walk would report it again
        }
        for (const fs::path& file : walks) {
            note([&] { check_walk(project, *selector, file); });
        }
    }

    /// A walk may name what the project's campus lacks.
    void check_walk(const ProjectConfig& project, const Selector& selector, const fs::path& file) {
        config::Run run = loader_.read(file, project.overrides);
        if (selector.takes(file.generic_string(), run.walk.name, run.walk.tags)) {
            ++projects_of_[file];
            for (Diagnostic& warning : WalkLoader::check_go_to(loader_.ready(std::move(run)))) {
                note_warning(project, file, std::move(warning));
            }
        }
    }

    void note_warning(const ProjectConfig& project, const fs::path& file, Diagnostic warning) {
        const auto same = std::ranges::find_if(warnings_, [&](const WalkWarning& each) {
            return scene::to_string(each.warning) == scene::to_string(warning);
        });
        WalkWarning& noted = same != warnings_.end()
                                 ? *same
                                 : warnings_.emplace_back(WalkWarning{file, std::move(warning), {}});
        noted.projects.push_back(project.name);
    }

    /// What a walk gets to may depend on the project, whose avatar or campus replaces the walk's own.
    void warn_of_walks() {
        std::vector<Diagnostic> warnings;
        for (WalkWarning& each : warnings_) {
            if (each.projects.size() < projects_of_.at(each.file)) {
                std::string names;
                for (const std::string& name : each.projects) {
                    names += (names.empty() ? "'" : ", '") + name + "'";
                }
                each.warning.message = (each.projects.size() == 1 ? "in project " : "in projects ") + names +
                                       ": " + each.warning.message;
            }
            warnings.push_back(std::move(each.warning));
        }
        warn_(warnings);
    }

    struct WalkWarning {
        fs::path file;
        Diagnostic warning;
        std::vector<std::string> projects;  ///< that have it
    };

    WalkLoader& loader_;
    const WalksConfig& config_;
    const WalkLoader::Warn& warn_;
    std::map<fs::path, std::size_t> projects_of_;  ///< of a walk: how many take it
    std::vector<WalkWarning> warnings_;
    scene::DiagnosticList found_;
};

}  // namespace

std::size_t check_config(WalkLoader& loader, const fs::path& file, const WalkLoader::Warn& warn) {
    const WalksConfig config = config::load_walks_config(file, search_paths());
    ConfigCheck(loader, config, warn).run();
    return config.projects.size();
}

}  // namespace campuswalk::tools
