#include "tools/campuswalk/run/cases/run_fingerprint.h"

#include <filesystem>

#include "scene/cache/content_hash.h"
#include "scene/cache/file_hash.h"
#include "tools/campuswalk/loading/cache_choice.h"
#include "tools/campuswalk/run/plan/plan_hash.h"

namespace campuswalk::tools {

namespace {

std::string hash_of_text(std::string_view text) {
    scene::ContentHasher hasher;
    hasher.add_text(text);
    return to_string(hasher.result());
}

std::string hash_of_files(const std::vector<Inputs>& inputs) {
    scene::ContentHasher hasher;
    FileHashes hashes;
    for (const Inputs& each : inputs) {
        hasher.add_text(each.owner);
        hasher.add_number(std::uint64_t{each.files.size()});
        for (const std::filesystem::path& file : each.files) {
            hasher.add_text(file.filename().string());
            hasher.add_hash(hashes.of(file));
        }
    }
    return to_string(hasher.result());
}

}  // namespace

engine::RunFingerprint run_fingerprint(const Plan& plan, std::string_view options) {
    // Not the build: all builds of a version give the same bytes.
    return {CAMPUSWALK_VERSION, hash_of_text(options), hash_of_files(plan.inputs)};
}

std::string resume_fingerprint(const engine::RunPlan& plan, std::string_view options) {
    scene::ContentHasher hasher;
    hasher.add_hash(scene::program_hash(model_cache()));
    hasher.add_text(options);
    for (const std::string* text : {&plan.contents, &plan.division, &plan.fingerprint.program,
                                    &plan.fingerprint.options, &plan.fingerprint.files}) {
        hasher.add_text(*text);
    }
    hasher.add_number(static_cast<std::uint64_t>(plan.shard));
    return to_string(hasher.result());
}

}  // namespace campuswalk::tools
