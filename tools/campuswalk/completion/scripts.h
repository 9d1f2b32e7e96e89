#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools::completion {

// Scripts that complete commands and options in a shell. `commands` are those of Command::describe(): the
// program itself, whose name is empty here, then its subcommands. Each script finds out from the words before
// the cursor which of them is being typed.

std::string bash_script(const std::vector<CommandInfo>& commands);
std::string zsh_script(const std::vector<CommandInfo>& commands);
std::string fish_script(const std::vector<CommandInfo>& commands);

// What the three have in common.

/// What a shell may offer for an option's value.
enum class Offer { nothing, words, files, folders };

Offer offer_for(const OptionInfo& option);
bool is_positional(const OptionInfo& option);
/// Whether a positional argument of the command is a file or a folder.
bool takes_files(const CommandInfo& command);
/// "run|info": all but the program itself.
std::string subcommand_names(const std::vector<CommandInfo>& commands, std::string_view between);

/// The part that bash and zsh share: the lines of a `case` on "COMMAND OPTION", for an option's value, then
/// those of a `case` on the command. `reply` returns what follows an option's pattern, `words` a command's
/// whole line; both with the line's end.
std::string cases(const std::vector<CommandInfo>& commands,
                  const std::function<std::string(const OptionInfo&)>& reply,
                  const std::function<std::string(const CommandInfo&)>& words);

}  // namespace campuswalk::tools::completion
