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

/// What the command line asks for; returns the exit code.
using Chosen = std::function<int()>;

/// How an option or a positional argument is spelled, explained and checked.
struct OptionSpec {
    std::string names;  ///< "-o,--output"; a word without dashes is a positional argument
    std::string help;
    std::string value = {};        ///< what is shown for its value: "FILE"; empty: nothing
    bool required = false;         ///< of options, one; of several values, at least one
    bool show_default = false;     ///< the target's value at this moment
    std::string excludes = {};     ///< an option added before, by its long name
    std::string environment = {};  ///< a variable that gives the value when the command line doesn't
    /// What is wrong with a value as it was written; empty when nothing is.
    std::function<std::string(const std::string&)> check = {};
};

template <typename Number>
struct Limits {
    Number least{};
    Number most{};
};

/// An option, a flag or a positional argument as the user may type it.
struct OptionInfo {
    std::vector<std::string> names;  ///< "-o", "--output"; one word without dashes: a positional argument
    std::string help;
    std::string value;                 ///< what the help shows for its value; empty: a flag
    std::vector<std::string> choices;  ///< the words it takes; empty: anything
};

/// A command and its options, in the help's order.
struct CommandInfo {
    std::string name;
    std::string description;
    std::vector<OptionInfo> options;
};

/// A command and its options. CLI11 stays behind it: that takes longer to compile than all of ours.
/// Targets must live until the command line has been read.
class Command {
public:
    explicit Command(CLI::App& app) : app_(&app) {}

    Command add(const std::string& name, const std::string& description);
    /// Sets `chosen`, which must live until then, when the user names this command.
    void choose(Chosen& chosen, Chosen action);
    /// What the help says below the options.
    void footer(const std::string& text);
    /// This command, with an empty name, and the commands that have been added to it so far.
    std::vector<CommandInfo> describe() const;

    /// A string or a path, also as std::optional or, for several values, as std::vector.
    template <typename Value>
    void option(const OptionSpec& spec, Value& target);
    void option(const OptionSpec& spec, int& target, const Limits<int>& limits);
    void option(const OptionSpec& spec, std::optional<int>& target, const Limits<int>& limits);
    void option(const OptionSpec& spec, double& target, const Limits<double>& limits);
    void option(const OptionSpec& spec, std::optional<double>& target, const Limits<double>& limits);
    /// `take` is called with the value as it was written, once it has passed the check.
    void option(const OptionSpec& spec, const std::function<void(const std::string&)>& take);
    void flag(const OptionSpec& spec, bool& target);
    void flag(const OptionSpec& spec, std::function<void()> take);

    /// An option that takes one of a few words.
    template <typename Value>
    void choice(OptionSpec spec, const std::map<std::string, Value>& choices, Value& target) {
        std::vector<std::string> words;
        for (const auto& [word, value] : choices) {
            words.push_back(word);
        }
        restrict_to(words, spec);
        option(spec, [choices, &target](const std::string& word) { target = choices.at(word); });
    }

    /// An option that takes one of a few words each time it is named.
    void choices(OptionSpec spec, const std::vector<std::string>& words, std::vector<std::string>& target) {
        restrict_to(words, spec);
        option(spec, target);
    }

    /// A flag that takes one of a few words too, as in `--update=all`; `alone` is what it means without one.
    template <typename Value>
    void choice_flag(OptionSpec spec, const std::string& alone, const std::map<std::string, Value>& choices,
                     std::optional<Value>& target) {
        for (const auto& [word, value] : choices) {
            spec.value += (spec.value.empty() ? "[=" : "|") + word;
        }
        spec.value += "]";
        worded_flag(spec, alone, [choices, &target](const std::string& word) {
            const auto found = choices.find(word);
            if (found != choices.end()) {
                target = found->second;
            }
            return found != choices.end();
        });
    }

private:
    /// The option takes these words and no other, and shows them as its value.
    static void restrict_to(const std::vector<std::string>& words, OptionSpec& spec);
    /// `take` says whether it knows the word.
    void worded_flag(const OptionSpec& spec, const std::string& alone,
                     std::function<bool(const std::string&)> take);
    template <typename Value, typename Number>
    void add_number(OptionSpec spec, Value& target, const Limits<Number>& limits);
    void finish(CLI::Option& option, const OptionSpec& spec);

    CLI::App* app_;
};

struct ProgramName {
    std::string name;
    std::string description;
};

/// Reads the command line and does what it asks for. `add_commands` names what there is; `guarded` runs the
/// chosen one, and what merely prints. Returns the exit code.
int read_command_line(int argc, char** argv, const ProgramName& name,
                      const std::function<void(Command, Chosen&)>& add_commands,
                      const std::function<int(const Chosen&)>& guarded);

}  // namespace campuswalk::tools
