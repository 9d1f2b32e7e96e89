#include "tools/campuswalk/run/plan/shard.h"

#include <charconv>

#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace {

constexpr int kMaxShards = 1'000'000;

std::optional<int> parse_int(const std::string& text) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    const bool valid = result.ec == std::errc() && result.ptr == end && !text.empty();
    return valid && value >= 0 ? std::optional(value) : std::nullopt;
}

[[noreturn]] void refuse(const std::string& variable, const std::string& why) {
    throw error_about(variable, "bad-shard",
                      why + "; correct the variables, or pass --shard=1/1 for all walks");
}

int number_in(const Environment& environment, const std::string& name) {
    const std::optional<std::string> text = environment(name);
    if (!text) {
        refuse(name, "the variable isn't set, but others that require it are");
    }
    const std::optional<int> value = parse_int(*text);
    if (!value) {
        refuse(name, "'" + *text + "' isn't a whole number");
    }
    return *value;
}

Shard checked(int index, int count, const std::string& from) {
    if (count < 1 || count > kMaxShards || index >= count) {
        refuse(from, "index " + std::to_string(index) + " (from 0) is out of range for " +
                         std::to_string(count) + " shards");
    }
    return {index, count, from, ""};
}

Shard slurm_shard(const Environment& environment) {
    const std::string name = "SLURM_ARRAY_TASK_ID";
    const int first = number_in(environment, "SLURM_ARRAY_TASK_MIN");
    const int step =
        environment("SLURM_ARRAY_TASK_STEP") ? number_in(environment, "SLURM_ARRAY_TASK_STEP") : 1;
    const int offset = number_in(environment, name) - first;
    if (step < 1 || offset < 0 || offset % step != 0) {
        refuse(name, "it isn't SLURM_ARRAY_TASK_MIN plus a multiple of SLURM_ARRAY_TASK_STEP");
    }
    return checked(offset / step, number_in(environment, "SLURM_ARRAY_TASK_COUNT"), name);
}

}  // namespace

std::optional<Shard> parse_shard(const std::string& text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) {
        return std::nullopt;
    }
    const std::optional<int> number = parse_int(text.substr(0, slash));
    const std::optional<int> count = parse_int(text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count || *count > kMaxShards) {
        return std::nullopt;
    }
    return Shard{*number - 1, *count, "--shard", ""};
}

std::optional<Shard> shard_from(const Environment& environment) {
    const std::string index = "CAMPUSWALK_SHARD_INDEX";
    const std::string count = "CAMPUSWALK_SHARD_COUNT";
    if (environment(index)) {
        return checked(number_in(environment, index), number_in(environment, count), index);
    }
    if (environment("TEST_TOTAL_SHARDS")) {
        Shard shard = checked(number_in(environment, "TEST_SHARD_INDEX"),
                              number_in(environment, "TEST_TOTAL_SHARDS"), "TEST_SHARD_INDEX");
        shard.status_file = environment("TEST_SHARD_STATUS_FILE").value_or("");
        return shard;
    }
    if (environment("SLURM_ARRAY_TASK_ID")) {
        return slurm_shard(environment);
    }
    // Indexed jobs that have nothing to do with shards set the index too.
    if (environment("JOB_COMPLETION_INDEX") && environment(count)) {
        return checked(number_in(environment, "JOB_COMPLETION_INDEX"), number_in(environment, count),
                       "JOB_COMPLETION_INDEX");
    }
    if (environment(count)) {
        refuse(index, "CAMPUSWALK_SHARD_COUNT is set, but not which of them this is");
    }
    return std::nullopt;
}

Slice slice_of(std::size_t total, const Shard& shard) {
    const auto count = static_cast<std::size_t>(shard.count);
    const auto start = [&](std::size_t index) {
        return total / count * index + total % count * index / count;
    };
    const auto index = static_cast<std::size_t>(shard.index);
    return {start(index), start(index + 1)};
}

}  // namespace campuswalk::tools
