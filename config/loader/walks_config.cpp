#include "config/loader/walks_config.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "config/loader/read_whole.h"
#include "config/loader/values/checked_map.h"
#include "config/loader/values/folders_upwards.h"
#include "config/loader/values/names.h"
#include "config/loader/values/ranges.h"
#include "config/loader/values/yaml_file.h"
#include "config/loader/walk/read_late_expectation.h"

namespace campuswalk::config {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFileName = "walks.config.yaml";
constexpr int kMaxWorkers = 1024;
constexpr int kMaxFailures = 1'000'000;
constexpr int kMaxCases = 1'000'000;
constexpr std::size_t kMaxProjects = 100;

class WalksConfigReader {
public:
    explicit WalksConfigReader(fs::path folder) : folder_(std::move(folder)) {}

    void read(CheckedMap& map, WalksConfig& config) const {
        if (const auto walks = map.find("walks")) {
            for (const CheckedNode& entry : walks->items_or_one("an entry of 'walks'")) {
                config.walks.push_back({entry.mark(), path(entry).value_or(fs::path())});
            }
        }
        if (const auto output = map.find("output")) {
            config.output = MarkedPath{output->mark(), path(*output).value_or(folder_)};
        }
        if (const auto reporters = map.find("reporters")) {
            for (const CheckedNode& entry : reporters->items("a reporter")) {
                read_reporter(entry, config.reporters);
            }
        }
        if (const auto workers = map.find("workers")) {
            config.workers = workers->as_int(1, kMaxWorkers);
        }
        if (const auto most = map.find("max_failures")) {
            config.max_failures = most->as_int(1, kMaxFailures);
        }
        map.number("timeout", kTimeout, config.timeout);
        map.number("kill_after", kTimeout, config.kill_after);
        map.as_bool("forbid_only", config.forbid_only);
        map.as_bool("strict", config.strict);
        if (const auto least = map.find("min_cases")) {
            config.min_cases = least->as_int(1, kMaxCases);
        }
        if (const auto snapshots = map.find("snapshots")) {
            CheckedMap tolerance(*snapshots, "'snapshots'");
            read_tolerance(tolerance, config.snapshots);
            tolerance.refuse_other_keys();
        }
        if (const auto projects = map.find("projects")) {
            for (const CheckedNode::Entry& entry : projects->entries()) {
                config.projects.push_back(read_project(entry));
            }
            if (config.projects.size() > kMaxProjects) {  // every walk is read for each
                projects->diagnose("bad-value", "there may be " + std::to_string(kMaxProjects) +
                                                    " projects, not " +
                                                    std::to_string(config.projects.size()));
            }
        }
        std::ranges::stable_sort(config.projects, {}, &ProjectConfig::name);
    }

private:
    std::optional<fs::path> path(const CheckedNode& node) const {
        const std::optional<std::string> written = node.line();
        return written ? std::optional(folder_ / *written) : std::nullopt;
    }

    /// `list`, or `junit: FILE`.
    void read_reporter(const CheckedNode& node, std::vector<ConfiguredReporter>& reporters) const {
        if (node.is_scalar()) {
            reporters.push_back({node.mark(), node.line().value_or(""), std::nullopt});
            return;
        }
        const std::vector<CheckedNode::Entry> entries =
            node.is_map() ? node.entries() : std::vector<CheckedNode::Entry>();
        if (entries.size() != 1) {
            node.diagnose("wrong-type", "a reporter must be a name or {NAME: FILE}");
            return;
        }
        reporters.push_back({entries.front().key_mark, entries.front().key, path(entries.front().value)});
    }

    Override value_of(CheckedMap& map, const char* key) const {
        const auto node = map.find(key);
        if (!node) {
            return {};
        }
        return {std::make_shared<const YamlNode>(node->node()), node->file(), folder_};
    }

    ProjectConfig read_project(const CheckedNode::Entry& entry) const {
        check_kebab_key(entry);
        ProjectConfig project;
        project.mark = entry.key_mark;
        project.name = entry.key;
        if (entry.value.is_null()) {
            return project;  // the walks as they are
        }
        CheckedMap map(entry.value, "a project");
        project.overrides.campus = value_of(map, "campus");
        project.overrides.avatar = value_of(map, "avatar");
        project.overrides.spawn = value_of(map, "spawn");
        project.grep = marked(map, "grep");
        project.grep_invert = marked(map, "grep_invert");
        if (const auto tags = map.find("tags")) {
            for (const CheckedNode& tag : tags->items_or_one("a tag")) {
                project.tags.push_back(kebab_name(tag).value_or(""));
            }
        }
        map.number("timeout", kTimeout, project.timeout);
        map.refuse_other_keys();
        return project;
    }

    static std::optional<MarkedText> marked(CheckedMap& map, const char* key) {
        const auto node = map.find(key);
        const auto text = node ? node->line() : std::nullopt;
        return text ? std::optional(MarkedText{node->mark(), *text}) : std::nullopt;
    }

    fs::path folder_;
};

}  // namespace

WalksConfig load_walks_config(const fs::path& file, const SearchPaths& search) {
    return read_whole_file(file, search, [&](const auto& roots, const auto& mark, auto& diagnostics) {
        WalksConfig config;
        config.file = file;
        if (const auto yaml = YamlFile::open(file, ".config.yaml", roots, mark, diagnostics)) {
            CheckedMap map(yaml->root(), "a walks.config.yaml");
            WalksConfigReader(file.parent_path()).read(map, config);
            map.refuse_other_keys();
        }
        return config;
    });
}

std::optional<fs::path> find_walks_config(const fs::path& folder) {
    std::error_code ignored;
    for (const fs::path& above : folders_upwards(folder)) {
        const fs::file_status status = fs::status(above / kFileName, ignored);
        if (fs::is_regular_file(status) || fs::is_other(status)) {  // which is refused when it is read
            return (above / kFileName).lexically_normal();
        }
    }
    return std::nullopt;
}

}  // namespace campuswalk::config
