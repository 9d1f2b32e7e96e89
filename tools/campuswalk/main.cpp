#include "tools/campuswalk/command_line/program.h"
#include "tools/campuswalk/commands/commands.h"

using namespace campuswalk::tools;

int main(int argc, char** argv) {
    return run_program(argc, argv, {"campuswalk", "Headless walkthrough tests for virtual campuses."},
                       [](Command program, CommandAction& chosen) {
                           add_init(program, chosen);
                           add_import(program, chosen);
                           add_validate(program, chosen);
                           add_run(program, chosen);
                           add_merge_reports(program, chosen);
                           add_report(program, chosen);
                           add_diff(program, chosen);
                           add_imgdiff(program, chosen);
                           add_replay(program, chosen);
                           add_info(program, chosen);
                           add_snapshot(program, chosen);
                           add_collide(program, chosen);
                           add_explore(program, chosen);
                           add_route(program, chosen);
                           add_completion(program, chosen);
                           add_help(program, chosen);
                       });
}
