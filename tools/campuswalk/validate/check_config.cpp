#include "tools/campuswalk/validate/check_config.h"

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

namespace {

class ConfigCheck {
public:
    ConfigCheck(WalkLoader& loader, const WalksConfig& config) : loader_(loader), config_(config) {}

    void run() {
        for (const config::ConfiguredReporter& reporter : config_.reporters) {
            note([&] { check_reporter(reporter.name, reporter.mark); });
        }
        const std::vector<fs::path> walks = walk_files();
        for (const ProjectConfig& project : config_.projects) {
            check(project, walks);
        }
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
        std::vector<fs::path> there;
        for (const config::MarkedPath& walks : config_.walks) {
            std::error_code none;
            if (fs::exists(walks.path, none)) {
                there.push_back(as_seen_from_here(walks.path));
            } else {
                found_.error(walks.mark, "missing-file",
                             "there is no '" + walks.path.generic_string() + "'; check the path");
            }
        }
        if (config_.walks.empty()) {
            there.push_back(as_seen_from_here(config_.file.parent_path() / "."));
        }
        std::vector<fs::path> files;
        note([&] { files = find_walks(there); });
        return files;
    }

    void check(const ProjectConfig& project, const std::vector<fs::path>& walks) {
        std::optional<Selector> selector;
        const bool selects = note([&] { selector = selector_of(project); });
        const bool names_hold = note([&] { loader_.check(project.overrides); });
        if (!selects || !names_hold) {
            return;  // every walk would say it once more
        }
        for (const fs::path& file : walks) {
            note([&] { play(project, *selector, file); });
        }
    }

    /// As far as it goes without playing: a walk may lack what the project's campus has, and the other way
    /// round.
    void play(const ProjectConfig& project, const Selector& selector, const fs::path& file) {
        config::SharedRun run = loader_.read(file, project.overrides);
        if (selector.takes(file.generic_string(), run.walk.name, run.walk.tags)) {
            loader_.ready(std::move(run));
        }
    }

    WalkLoader& loader_;
    const WalksConfig& config_;
    scene::DiagnosticList found_;
};

}  // namespace

std::size_t check_config(WalkLoader& loader, const fs::path& file) {
    const WalksConfig config = config::load_walks_config(file);
    ConfigCheck(loader, config).run();
    return config.projects.size();
}

}  // namespace campuswalk::tools
