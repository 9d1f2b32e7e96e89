#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace campuswalk::tools {

/// Runs the command that the user chose; returns the exit code.
using CommandAction = std::function<int()>;

/// How an option or a positional argument is spelled, explained and checked.
struct OptionSpec {
    std::string names;  ///< "-o,--output"; a word without dashes is a positional argument
    std::string help;
    std::string value = {};        ///< placeholder in the help: "FILE"; empty: none
    bool required = false;         ///< where several values are taken, at least one
    bool show_default = false;     ///< the target's current value
    bool is_list = false;          ///< one word may be several values, with commas between them
    std::string excludes = {};     ///< an option that was added before, by its long name
    std::string environment = {};  ///< a variable with the value, used when the command line has none
    /// Returns what is wrong with a value as written; empty when nothing is.
    std::function<std::string(const std::string&)> check = {};
};

template <typename Number>
struct Limits {
    Number min{};
    Number max{};
};

/// An option, a flag or a positional argument as the user may type it.
struct OptionInfo {
    std::vector<std::string> names;  ///< "-o", "--output"; one word without dashes: a positional argument
    std::string help;
    std::string value;                 ///< placeholder in the help; empty: a flag
    std::vector<std::string> choices;  ///< the words it takes; empty: anything
};

/// A command and its options, in the help's order.
struct CommandInfo {
    std::string name;
    std::string description;
    std::vector<OptionInfo> options;
};

/// A command and its options. Hides CLI11, which takes longer to compile than all of our code. Targets must
/// live until the command line has been parsed.
class Command {
public:
    explicit Command(CLI::App& app) : app_(&app) {}

    Command add(const std::string& name, const std::string& description);
    /// Sets `chosen`, which must live as long as targets, when the user names this command.
    void choose(CommandAction& chosen, CommandAction action);
    /// Text below the options in the help.
    void footer(const std::string& text);
    /// What the user has given of this command, one word an option, but without these options (by their long
    /// names). To be called by its action.
    std::vector<std::string> given_except(const std::vector<std::string>& names) const;
    /// This command, with an empty name, and the commands that have been added to it so far.
    std::vector<CommandInfo> describe() const;

    /// A string or a path, also as std::optional or, for several values, as std::vector.
    template <typename Value>
    void option(const OptionSpec& spec, Value& target);
    void option(const OptionSpec& spec, int& target, const Limits<int>& limits);
    void option(const OptionSpec& spec, std::optional<int>& target, const Limits<int>& limits);
    void option(const OptionSpec& spec, double& target, const Limits<double>& limits);
    void option(const OptionSpec& spec, std::optional<double>& target, const Limits<double>& limits);
    /// Calls `take` with the value as written, once it has passed the check.
    void option(const OptionSpec& spec, const std::function<void(const std::string&)>& take);
    void flag(const OptionSpec& spec, bool& target);
    void flag(const OptionSpec& spec, std::function<void()> take);

    /// An option that takes one of a few words.
    template <typename Value>
    void choice(OptionSpec spec, const std::map<std::string, Value>& choices, Value& target) {
        std::vector<std::string> words;
        words.reserve(choices.size());
        for (const auto& [word, value] : choices) {
            words.push_back(word);
        }
        restrict_to(words, spec);
        option(spec, [choices, &target](const std::string& word) { target = choices.at(word); });
    }

    /// An option that takes one of a few words each time it is given.
    void choices(OptionSpec spec, const std::vector<std::string>& words, std::vector<std::string>& target) {
        restrict_to(words, spec);
        option(spec, target);
    }

    /// A flag that also takes one of a few words, as in `--update=all`; without one it means `default_word`.
    template <typename Value>
    void choice_flag(OptionSpec spec, const std::string& default_word,
                     const std::map<std::string, Value>& choices, std::optional<Value>& target) {
        for (const auto& [word, value] : choices) {
            spec.value += (spec.value.empty() ? "[=" : "|") + word;
        }
        spec.value += "]";
        flag_with_value(spec, default_word, [choices, &target](const std::string& word) {
            const auto found = choices.find(word);
            if (found != choices.end()) {
                target = found->second;
            }
            return found != choices.end();
        });
    }

private:
    /// Allows only these words, and shows them in the help as the value.
    static void restrict_to(const std::vector<std::string>& words, OptionSpec& spec);
    /// `take` returns whether it knows the word.
    void flag_with_value(const OptionSpec& spec, const std::string& default_word,
                         std::function<bool(const std::string&)> take);
    template <typename Value, typename Number>
    void add_number(OptionSpec spec, Value& target, const Limits<Number>& limits);
    void apply(CLI::Option& option, const OptionSpec& spec);

    CLI::App* app_;
};

struct ProgramName {
    std::string name;
    std::string description;
};

/// Parses the command line and runs the chosen command or prints help, a version or an error, all of it
/// through `guarded`. `add_commands` adds the commands. Returns the exit code.
int read_command_line(int argc, char** argv, const ProgramName& name,
                      const std::function<void(Command, CommandAction&)>& add_commands,
                      const std::function<int(const CommandAction&)>& guarded);

}  // namespace campuswalk::tools
