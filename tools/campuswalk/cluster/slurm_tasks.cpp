#include "tools/campuswalk/cluster/slurm_tasks.h"

#include <charconv>
#include <optional>

#include "tools/campuswalk/base/text.h"
#include "tools/campuswalk/cluster/slurm_program.h"

namespace campuswalk::tools {

namespace {

constexpr int kMostTasks = 4'000'001;  // MaxArraySize may be that in Slurm

std::optional<int> task_number(std::string_view text) {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    const bool valid =
        parsed.ec == std::errc() && parsed.ptr == end && !text.empty() && number >= 0 && number <= kMostTasks;
    return valid ? std::optional(number) : std::nullopt;
}

/// "CANCELLED by 1000" is CANCELLED.
std::string state_word(std::string_view text) {
    return std::string(text.substr(0, text.find_first_of(" +")));
}

/// The value of `NAME=` in a line of such pairs.
std::string_view value_of(std::string_view line, std::string_view name) {
    for (const std::string_view pair : split(line, ' ')) {
        if (pair.starts_with(name)) {
            return pair.substr(name.size());
        }
    }
    return {};
}

}  // namespace

std::vector<int> tasks_in(std::string_view text) {
    if (text.starts_with('[') && text.ends_with(']')) {
        text = text.substr(1, text.size() - 2);
    }
    text = text.substr(0, text.find('%'));
    std::vector<int> tasks;
    for (std::string_view part : split(text, ',')) {
        const std::size_t colon = part.find(':');
        const int step =
            colon == std::string_view::npos ? 1 : task_number(part.substr(colon + 1)).value_or(0);
        part = part.substr(0, colon);
        const std::size_t dash = part.find('-');
        const std::optional<int> first = task_number(part.substr(0, dash));
        const std::optional<int> last =
            dash == std::string_view::npos ? first : task_number(part.substr(dash + 1));
        for (int task = first.value_or(1); first && last && step > 0 && task <= *last; task += step) {
            tasks.push_back(task);
        }
    }
    return tasks;
}

TaskStates states_from_accounting(std::string_view text) {
    TaskStates states;
    for (const std::string_view line : split(text, '\n')) {
        const std::size_t underscore = line.find('_');
        const std::size_t bar = line.find('|');
        if (underscore != std::string_view::npos && bar != std::string_view::npos && underscore < bar) {
            for (const int task : tasks_in(line.substr(underscore + 1, bar - underscore - 1))) {
                states[task] = state_word(line.substr(bar + 1));
            }
        }
    }
    return states;
}

TaskStates states_from_controller(std::string_view text) {
    TaskStates states;
    for (const std::string_view line : split(text, '\n')) {
        for (const int task : tasks_in(value_of(line, "ArrayTaskId="))) {
            states[task] = state_word(value_of(line, "JobState="));
        }
    }
    return states;
}

TaskStates ask_task_states(const std::string& job) {
    const SlurmAnswer accounts = ask_slurm(
        "sacct", {"--allocations", "--noheader", "--parsable2", "--jobs=" + job, "--format=JobID,State"});
    if (accounts.good()) {
        if (TaskStates states = states_from_accounting(accounts.text); !states.empty()) {
            return states;
        }
    }
    const SlurmAnswer controller = ask_slurm("scontrol", {"--oneliner", "show", "job", job});
    return controller.good() ? states_from_controller(controller.text) : TaskStates();
}

}  // namespace campuswalk::tools
