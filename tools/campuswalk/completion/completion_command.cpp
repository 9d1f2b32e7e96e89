#include "tools/campuswalk/completion/completion_command.h"

#include <cstdio>

#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/completion/scripts.h"

namespace campuswalk::tools {

int print_completion(const KnownCommand& program, Shell shell) {
    const std::vector<completion::Place> places = completion::places_of(program);
    const std::string script = shell == Shell::bash  ? completion::bash_script(places)
                               : shell == Shell::zsh ? completion::zsh_script(places)
                                                     : completion::fish_script(places);
    std::fputs(script.c_str(), stdout);
    return kPass;
}

}  // namespace campuswalk::tools
