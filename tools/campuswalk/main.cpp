#include <cstdio>
#include <exception>
#include <string_view>

#include "scene/base/diagnostic.h"
#include "scene/import/helper/serve_import.h"
#include "tools/campuswalk/command_line/commands.h"
#include "tools/campuswalk/complaints.h"
#include "tools/campuswalk/exit_codes.h"
#include "tools/campuswalk/standard_streams.h"
#include "tools/campuswalk/wanted_instructions.h"

using namespace campuswalk;
using namespace campuswalk::tools;

namespace {

void add_commands(Command program, Chosen& chosen) {
    add_init(program, chosen);
    add_validate(program, chosen);
    add_run(program, chosen);
    add_merge_reports(program, chosen);
    add_diff(program, chosen);
    add_imgdiff(program, chosen);
    add_replay(program, chosen);
    add_info(program, chosen);
    add_snapshot(program, chosen);
    add_collide(program, chosen);
    add_bench(program, chosen);
    add_completion(program, chosen);
    add_help(program, chosen);
}

int guarded(const Chosen& command) {
    try {
        use_simd_target_from_environment();
        const int exit_code = command();
        check_standard_output();
        return exit_code;
    } catch (const scene::InputError& error) {
        diagnose(error.diagnostics());
        return kBadInput;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return kRunFailed;
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && argv[1] == std::string_view(scene::kImportHelperArgument)) {
        return scene::serve_import();  // started by ourselves: see model_importer.h
    }
    guard_standard_streams();
    return read_command_line(argc, argv, add_commands, guarded);
}
