#include "tools/campuswalk/command_line/command.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "scene/base/diagnostic.h"
#include "scene/base/printable.h"
#include "tools/campuswalk/base/exit_codes.h"
#include "tools/campuswalk/base/text.h"

namespace campuswalk::tools {

namespace {

constexpr const char* kVersion = "campuswalk " CAMPUSWALK_VERSION;

/// For an unknown command, CLI11 only says that one is missing.
std::string command_message(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        names.push_back(command->get_name());
    }
    const std::vector<std::string> unknown = app.remaining();
    if (unknown.empty()) {
        return "a command is needed: " + joined(names, ", ");
    }
    const std::string& word = unknown.front();
    return "there is no " + std::string(word.starts_with('-') ? "option" : "command") + " '" + word + "'" +
           scene::did_you_mean(word, names);
}

/// CLI11 names an unknown option, but suggests no other.
std::string option_message(const CLI::App& app, const CLI::Error& error) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            names.push_back("--" + name);
        }
    }
    for (const std::string& word : app.remaining()) {
        if (word.starts_with("--")) {
            return error.what() + scene::did_you_mean(word.substr(0, word.find('=')), names);
        }
    }
    return error.what();
}

/// What was typed may come from a script that got it from elsewhere: its words stay words.
std::string failure_message(const CLI::App* app, const CLI::Error& error) {
    if (app->get_subcommands().empty()) {
        return "error: " + scene::printable(command_message(*app)) + "\nsee " + app->get_name() + " --help\n";
    }
    const CLI::App& command = *app->get_subcommands().front();
    return "error: " + scene::printable(option_message(command, error)) + "\nsee " + app->get_name() + " " +
           command.get_name() + " --help\n";
}

/// `choice` shows its words as "a|b|c"; no other placeholder of a value contains a '|'.
std::vector<std::string> choices_in(const std::string& value) {
    const std::vector<std::string_view> words = split(value, '|');
    return words.size() > 1 ? std::vector<std::string>(words.begin(), words.end())
                            : std::vector<std::string>();
}

OptionInfo describe_option(const CLI::Option& option) {
    OptionInfo info;
    for (const std::string& name : option.get_snames()) {
        info.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        info.names.push_back("--" + name);
    }
    if (option.get_positional()) {
        info.names.push_back(option.get_name());
    }
    info.help = option.get_description();
    info.value = option.get_items_expected_max() > 0 ? option.get_type_name() : "";
    info.choices = choices_in(info.value);
    return info;
}

CommandInfo describe_command(const std::string& name, const CLI::App& app) {
    CommandInfo info{name, app.get_description(), {}};
    for (const CLI::Option* option : app.get_options()) {
        info.options.push_back(describe_option(*option));
    }
    return info;
}

}  // namespace

std::vector<CommandInfo> Command::describe() const {
    std::vector<CommandInfo> commands = {describe_command("", *app_)};
    for (const CLI::App* command : app_->get_subcommands({})) {
        commands.push_back(describe_command(command->get_name(), *command));
    }
    return commands;
}

std::vector<std::string> Command::given_except(const std::vector<std::string>& names) const {
    std::vector<std::string> options;
    std::vector<std::string> positional;
    for (const CLI::Option* option : app_->get_options()) {
        const bool is_named = !option->get_lnames().empty() || !option->get_snames().empty();
        const std::string name = !is_named                      ? ""
                                 : option->get_lnames().empty() ? "-" + option->get_snames().front()
                                                                : "--" + option->get_lnames().front();
        if (option->count() == 0 || std::ranges::find(names, name) != names.end()) {
            continue;
        }
        for (const std::string& value : option->results()) {
            const bool bare = option->get_items_expected_max() == 0 && value == "true";
            if (!is_named) {
                positional.push_back(value);
            } else {
                options.push_back(name);
                options.back() += bare ? "" : "=" + value;
            }
        }
    }
    if (!positional.empty()) {
        options.emplace_back("--");  // a path may begin with a dash
        options.insert(options.end(), positional.begin(), positional.end());
    }
    return options;
}

Command Command::add(const std::string& name, const std::string& description) {
    CLI::App* command = app_->add_subcommand(name, description);
    command->set_version_flag("--version", kVersion);
    return Command(*command);
}

void Command::choose(CommandAction& chosen, CommandAction action) {
    app_->callback([&chosen, action = std::move(action)] { chosen = action; });
}

void Command::footer(const std::string& text) {
    app_->footer(text);
}

void Command::apply(CLI::Option& option, const OptionSpec& spec) {
    option.type_name(spec.value)->required(spec.required);
    if (spec.check) {
        option.check(spec.check);
    }
    if (spec.show_default) {
        option.capture_default_str();
    }
    if (spec.is_list) {
        option.delimiter(',');
    }
    if (!spec.excludes.empty()) {
        option.excludes(app_->get_option(spec.excludes));
    }
    if (!spec.environment.empty()) {
        option.envname(spec.environment);
    }
}

template <typename Value>
void Command::option(const OptionSpec& spec, Value& target) {
    CLI::Option* option = app_->add_option(spec.names, target, spec.help);
    apply(*option, spec);
    if (option->get_items_expected_max() > 1) {
        // One value each time it is given: what follows belongs to the command.
        option->allow_extra_args(!spec.names.starts_with('-'));
    }
}
template void Command::option(const OptionSpec&, std::string&);
template void Command::option(const OptionSpec&, std::filesystem::path&);
template void Command::option(const OptionSpec&, std::optional<std::string>&);
template void Command::option(const OptionSpec&, std::optional<std::filesystem::path>&);
template void Command::option(const OptionSpec&, std::vector<std::string>&);
template void Command::option(const OptionSpec&, std::vector<std::filesystem::path>&);

template <typename Value, typename Number>
void Command::add_number(OptionSpec spec, Value& target, const Limits<Number>& limits) {
    spec.value = spec.value.empty() ? "N" : spec.value;
    CLI::Option* option = app_->add_option(spec.names, target, spec.help);
    apply(*option, spec);
    option->check(CLI::Range(limits.min, limits.max));
}
void Command::option(const OptionSpec& spec, int& target, const Limits<int>& limits) {
    add_number(spec, target, limits);
}
void Command::option(const OptionSpec& spec, std::optional<int>& target, const Limits<int>& limits) {
    add_number(spec, target, limits);
}
void Command::option(const OptionSpec& spec, double& target, const Limits<double>& limits) {
    add_number(spec, target, limits);
}
void Command::option(const OptionSpec& spec, std::optional<double>& target, const Limits<double>& limits) {
    add_number(spec, target, limits);
}

void Command::option(const OptionSpec& spec, const std::function<void(const std::string&)>& take) {
    apply(*app_->add_option_function<std::string>(spec.names, take, spec.help), spec);
}

void Command::restrict_to(const std::vector<std::string>& words, OptionSpec& spec) {
    spec.value = joined(words, "|");
    spec.check = [words, shown = spec.value](const std::string& word) {
        const bool known = std::ranges::find(words, word) != words.end();
        return known ? std::string() : "'" + word + "' is not one of " + shown;
    };
}

void Command::flag(const OptionSpec& spec, bool& target) {
    apply(*app_->add_flag(spec.names, target, spec.help), spec);
}

void Command::flag(const OptionSpec& spec, std::function<void()> take) {
    apply(*app_->add_flag_callback(spec.names, std::move(take), spec.help), spec);
}

void Command::flag_with_value(const OptionSpec& spec, const std::string& default_word,
                              std::function<bool(const std::string&)> take) {
    // CLI11 gives a flag the value "true" unless one is written after '='.
    const CLI::callback_t callback = [take = std::move(take), default_word](const CLI::results_t& words) {
        return take(words.back() == "true" ? default_word : words.back());
    };
    CLI::Option* flag = app_->add_option(spec.names, callback, spec.help)
                            ->expected(0)
                            ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    apply(*flag, spec);
}

int read_command_line(int argc, char** argv, const ProgramName& name,
                      const std::function<void(Command, CommandAction&)>& add_commands,
                      const std::function<int(const CommandAction&)>& guarded) {
    CLI::App app(name.description, name.name);
    app.set_version_flag("--version", kVersion);
    app.require_subcommand(1);
    app.failure_message(failure_message);
    CommandAction chosen;
    add_commands(Command(app), chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return guarded([&] { return app.exit(error) == 0 ? kPass : kBadInput; });
    }
    return guarded(chosen);
}

}  // namespace campuswalk::tools
