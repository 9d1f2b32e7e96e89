#include "tools/campuswalk/run/plan/plan_hash.h"

#include <cstdint>
#include <set>

#include "scene/cache/file_hash.h"
#include "tools/campuswalk/loading/cache_choice.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

const scene::ContentHash& FileHashes::of(const fs::path& file) {
    const auto [known, is_new] = known_.try_emplace(file);
    if (is_new) {
        known->second = scene::hash_of_file(file, model_cache()).value_or(scene::ContentHash());
    }
    return known->second;
}

void PlanContents::add(const engine::WalkResult& planned, const config::Run* run) {
    hasher_.add_text(planned.id);
    // In an order that doesn't depend on the paths: those of the program's own profiles are another
    // machine's.
    std::set<fs::path> added;
    const auto add_once = [&](const fs::path& file) {
        if (!file.empty() && added.insert(file).second) {
            hasher_.add_hash(files_.of(file));
        }
    };
    add_once(planned.file);
    add_once(planned.config);
    if (run != nullptr) {
        hasher_.add_number(run->walk.timeout.value_or(-1.0));
        hasher_.add_number(static_cast<std::uint64_t>(run->walk.sim.tree));
        add_once(run->walk.campus);
        for (const fs::path& profile : run->profiles) {
            add_once(profile);
        }
        // A file that only includes others has no step whose mark would name it.
        hasher_.add_number(std::uint64_t{run->walk.included.size()});
        for (const fs::path& file : run->walk.included) {
            hasher_.add_hash(files_.of(file));
        }
    }
}

void Division::add(int shard, std::string_view case_id) {
    hasher_.add_number(static_cast<std::uint64_t>(shard));
    hasher_.add_text(case_id);
}

}  // namespace campuswalk::tools
