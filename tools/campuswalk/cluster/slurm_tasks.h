#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace campuswalk::tools {

/// Slurm's words for how the tasks of an array job are, by the tasks' numbers: "RUNNING", "CANCELLED",
/// "TIMEOUT", …
using TaskStates = std::map<int, std::string>;

/// What Slurm knows of the array job `job`: from its accounting, or else what its controller still remembers
/// (for MinJobAge, five minutes by default). It may know nothing.
TaskStates ask_task_states(const std::string& job);

// The formats of their answers.

/// `sacct --parsable2 --format=JobID,State`: "12_3|CANCELLED by 1000".
TaskStates states_from_accounting(std::string_view text);
/// `scontrol --oneliner show job`: "… ArrayTaskId=3 … JobState=CANCELLED …".
TaskStates states_from_controller(std::string_view text);
/// The tasks in "3", "[3-5,9]" or "[1-9:2%4]".
std::vector<int> tasks_in(std::string_view text);

}  // namespace campuswalk::tools
