#include "tools/campuswalk/loading/model_importer.h"

#include <unistd.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "scene/import/helper/import_process.h"
#include "scene/import/helper/sandbox.h"
#include "scene/import/helper/serve_import.h"
#include "scene/osm/helper/map_process.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/loading/cache_choice.h"

namespace campuswalk::tools {

namespace {

scene::SandboxMode sandbox = scene::SandboxMode::automatic;

/// Says what the kernel lacks, or refuses to do without it.
void check_sandbox() {
    const std::vector<std::string> missing = scene::missing_sandbox_features();
    if (sandbox == scene::SandboxMode::off || missing.empty()) {
        return;
    }
    const std::string lacks =
        "this kernel lacks " + joined(missing, " and ") + " for the sandbox of model imports";
    if (sandbox == scene::SandboxMode::require) {
        throw error_about("--sandbox", "no-sandbox", lacks);
    }
    diagnose({{scene::Severity::warning, {}, "no-sandbox", lacks + "; --sandbox off accepts that"}});
}

/// When the first model is imported: caches need none.
void check_sandbox_once() {
    static std::once_flag checked;
    std::call_once(checked, check_sandbox);
}

/// For all imports at once, bytes: 8 GB, or half of a larger machine's.
std::uint64_t import_memory() {
    const auto machine = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    return std::max(scene::ImportLimits().memory, machine / 2);
}

}  // namespace

std::size_t imports_at_once(std::size_t models) {
    const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
    const auto most = static_cast<std::size_t>(import_memory() >> 30U);
    return std::clamp(models, std::size_t{1}, std::min(processors, most));
}

scene::Importer model_importer(std::size_t at_once) {
    scene::ImportLimits limits;
    limits.memory = import_memory() / at_once;
    // This program, even if its file has been replaced meanwhile.
    scene::Importer importer =
        scene::import_in_process({"/proc/self/exe", {scene::kImportHelperArgument}}, limits, sandbox);
    return [importer = std::move(importer)](const scene::SceneFile& file, scene::EmptyModel if_empty) {
        check_sandbox_once();
        return importer(file, if_empty);
    };
}

scene::osm::MapFiles read_osm_map(const scene::osm::MapRequest& request) {
    check_sandbox();
    scene::ImportLimits limits;
    limits.memory = import_memory();
    // Geometry is made from it: ten times what any map has taken. Before that its own budgets end an import,
    // on every machine alike.
    limits.cpu = 150;
    limits.cpu_per_megabyte = 20;
    return scene::osm::import_map_in_process({"/proc/self/exe", {scene::osm::kMapHelperArgument}}, request,
                                             limits, sandbox);
}

std::vector<scene::ForeignImage> decode_images(std::span<const std::string_view> files) {
    check_sandbox_once();
    return scene::decode_in_process({"/proc/self/exe", {scene::kImageHelperArgument}}, files, sandbox);
}

void add_import_options(Command command) {
    add_cache_flag(command);
    const std::map<std::string, scene::SandboxMode> modes = {{"auto", scene::SandboxMode::automatic},
                                                             {"require", scene::SandboxMode::require},
                                                             {"off", scene::SandboxMode::off}};
    command.choice(
        {.names = "--sandbox",
         .help = "Whether processes that import models may only read the models' folders and compute; "
                 "auto does what the kernel can"},
        modes, sandbox);
}

scene::LoadedModel read_model(const scene::SceneFile& file, scene::EmptyModel empty) {
    return load_model(file, empty, model_importer(), model_cache());
}

}  // namespace campuswalk::tools
