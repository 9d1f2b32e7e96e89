#include "tools/campuswalk/command_line/program.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "collision/base/simd_target.h"
#include "scene/import/helper/image_process.h"
#include "scene/import/helper/serve_import.h"
#include "scene/osm/helper/map_process.h"
#include "tools/campuswalk/base/environment.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/standard_streams.h"

namespace campuswalk::tools {

namespace {

/// Applies CAMPUSWALK_INSTRUCTIONS if it is set; results are the same for every target.
void choose_simd_target() {
    using collision::SimdTarget;
    const std::optional<std::string> requested = environment_variable("CAMPUSWALK_INSTRUCTIONS");
    if (!requested) {
        return;
    }
    const std::map<std::string, SimdTarget> known = {
        {"sse42", SimdTarget::sse42}, {"avx2", SimdTarget::avx2}, {"avx512", SimdTarget::avx512}};
    const auto found = known.find(*requested);
    if (found == known.end() || !can_run(found->second)) {
        const char* why =
            found == known.end() ? "' is not one of sse42, avx2, avx512" : "': this processor can't";
        throw error_about("CAMPUSWALK_INSTRUCTIONS", "bad-value", "'" + *requested + why);
    }
    collision::use_simd_target(found->second);
}

int guarded(const CommandAction& command) {
    return report_exceptions([&] {
        choose_simd_target();
        const int exit_code = command();
        check_standard_output();
        return exit_code;
    });
}

}  // namespace

int run_program(int argc, char** argv, const ProgramName& name,
                const std::function<void(Command, CommandAction&)>& add_commands) {
    if (argc == 2 && argv[1] == std::string_view(scene::kImportHelperArgument)) {
        return scene::serve_import();
    }
    if (argc == 2 && argv[1] == std::string_view(scene::kImageHelperArgument)) {
        return scene::serve_images();
    }
    if (argc == 2 && argv[1] == std::string_view(scene::osm::kMapHelperArgument)) {
        return scene::osm::serve_map();
    }
    guard_standard_streams();
    return read_command_line(argc, argv, name, add_commands, guarded);
}

}  // namespace campuswalk::tools
