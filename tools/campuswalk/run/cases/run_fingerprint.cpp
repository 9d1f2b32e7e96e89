#include "tools/campuswalk/run/cases/run_fingerprint.h"

#include <filesystem>
#include <set>
#include <system_error>

#include "scene/cache/content_hash.h"
#include "scene/cache/file_hash.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/logs/golden_log.h"
#include "tools/campuswalk/run/plan/plan_hash.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

/// Reads every file once.
class FingerprintHasher {
public:
    explicit FingerprintHasher(std::string_view settings) {
        hasher_.add_hash(scene::program_hash(model_cache()));
        hasher_.add_text(settings);
    }

    void add(const Plan& plan) {
        hasher_.add_text(plan.summary.contents);
        hasher_.add_text(plan.summary.division);
        for (const Case& each : plan.cases) {
            add(each);
        }
    }

    std::string text() const { return to_string(hasher_.result()); }

private:
    void add(const Case& each) {
        hasher_.add_text(each.result.id);
        if (!each.walk) {
            return;
        }
        hasher_.add_number(each.walk->walk.timeout.value_or(-1.0));
        for (const fs::path& file : each.walk->campus->files) {
            add_file(file);
        }
        const fs::path goldens = golden_log_file(each.result.file, each.result.project).parent_path();
        std::error_code ignored;
        std::set<fs::path> files;
        for (const fs::directory_entry& entry : fs::directory_iterator(goldens, ignored)) {
            files.insert(entry.path());
        }
        for (const fs::path& file : files) {
            add_file(file);
        }
    }

    void add_file(const fs::path& file) {
        hasher_.add_text(file.filename().string());
        hasher_.add_hash(files_.of(file));
    }

    scene::ContentHasher hasher_;
    FileHashes files_;
};

}  // namespace

std::string run_fingerprint(const Plan& plan, std::string_view settings) {
    FingerprintHasher hasher(settings);
    hasher.add(plan);
    return hasher.text();
}

}  // namespace campuswalk::tools
