#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/campuswalk/command_line/command.h"

namespace campuswalk::tools::completion {

/// What a shell may offer for an option's value.
enum class Offer { nothing, words, files, folders };

Offer offer_for(const KnownOption& option);
bool is_positional(const KnownOption& option);

/// A command by the way to it: "/bench/ray", "" for the program itself. The command must outlive it.
struct Place {
    std::string path;
    const KnownCommand* command = nullptr;
};

/// The program and every command below it.
std::vector<Place> places_of(const KnownCommand& program);

/// "/run|/bench|/bench/ray": all but the program itself.
std::string all_paths(const std::vector<Place>& places, std::string_view between);
/// Commands' names, then words for positional arguments.
std::vector<std::string> plain_words(const KnownCommand& command);
/// Whether a positional argument of the command is a file or a folder.
bool takes_files(const KnownCommand& command);

/// What bash and zsh take alike: the lines of a `case` on "PLACE OPTION", which is over where an option's
/// value is due, then those of one on the place. `reply` gives what is done for an option, `words` all of a
/// place's line; both with the end of the line.
std::string cases(const std::vector<Place>& places,
                  const std::function<std::string(const KnownOption&)>& reply,
                  const std::function<std::string(const Place&)>& words);

std::string joined(const std::vector<std::string>& words, std::string_view between);

// The scripts; each works out at which place it is from the words before the cursor.

std::string bash_script(const std::vector<Place>& places);
std::string zsh_script(const std::vector<Place>& places);
std::string fish_script(const std::vector<Place>& places);

}  // namespace campuswalk::tools::completion
