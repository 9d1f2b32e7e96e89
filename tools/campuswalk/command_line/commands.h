#pragma once

#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools {

// Each adds a command and its options, a file each; the one the user names sets `chosen`.

void add_init(Command program, Chosen& chosen);
void add_validate(Command program, Chosen& chosen);
void add_run(Command program, Chosen& chosen);
void add_merge_reports(Command program, Chosen& chosen);
void add_diff(Command program, Chosen& chosen);
void add_imgdiff(Command program, Chosen& chosen);
void add_replay(Command program, Chosen& chosen);
void add_info(Command program, Chosen& chosen);
void add_snapshot(Command program, Chosen& chosen);
void add_collide(Command program, Chosen& chosen);
void add_bench(Command program, Chosen& chosen);
void add_completion(Command program, Chosen& chosen);
void add_help(Command program, Chosen& chosen);

}  // namespace campuswalk::tools
