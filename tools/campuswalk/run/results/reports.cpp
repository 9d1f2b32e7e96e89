#include "tools/campuswalk/run/results/reports.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <system_error>

#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

const char* code_for(const ReportTarget& target) {
    return target.name == "log" || target.name == "jsonl-log" ? "log-unwritable" : "report-unwritable";
}

scene::InputError about(const ReportTarget& target, const std::string& message) {
    return error_about(*target.file, code_for(target), message);
}

std::string noun(const ReportTarget& target) {
    return std::string(code_for(target)).starts_with("log") ? "log" : "report";
}

/// Whether a file begins like a report of this kind, or is empty.
bool begins_like(std::string_view kind, const fs::path& file) {
    const std::map<std::string_view, std::vector<std::string_view>> beginnings = {
        {"list", {"pass  ", "FAIL  ", "skip  ", "xfail ", "STOP  ", "ERROR "}},
        {"junit", {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"campuswalk\""}},
        {"tap", {"TAP version 14"}},
        {"json", {"{\"campuswalk_report\":"}},
        {"jsonl", {"{\"campuswalk_results\":"}},
        {"github", {"::error ", "::notice title=campuswalk::"}},
        {"log", {"# walk-log "}}};
    constexpr std::size_t kEnough = 100;  // characters
    std::ifstream stream(file, std::ios::binary);
    std::string text(kEnough, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(stream.gcount()));
    const std::string line = text.substr(0, text.find('\n'));
    if (kind == "list" || kind == "dot") {  // with --quiet they are a summary: "12 passed"
        const std::size_t digits = line.find_first_not_of("0123456789");
        if (text.starts_with("\n1) ") ||
            (digits != 0 && digits != std::string::npos && line.substr(digits).starts_with(" passed"))) {
            return true;
        }
    }
    if (kind == "dot" && !text.empty()) {
        return !line.empty() && line.find_first_not_of(".xFsIE") == std::string::npos;
    }
    return text.empty() || std::ranges::any_of(beginnings.at(kind), [&](std::string_view beginning) {
               return text.starts_with(beginning);
           });
}

void check_target(const ReportTarget& target) {
    if (target.file->extension() == ".yaml") {  // as in `--log a.walk.yaml b.walk.yaml`
        throw about(target, "a " + noun(target) + " would overwrite this YAML file; name another");
    }
    if (const std::string why = why_file_unwritable(*target.file); !why.empty()) {
        throw about(target, "the " + noun(target) + " can't be written here: " + why);
    }
    std::error_code ignored;
    if (target.configured && fs::exists(*target.file, ignored) && !begins_like(target.name, *target.file)) {
        throw scene::InputError(*target.configured, code_for(target),
                                "'" + target.file->generic_string() + "' isn't a " + noun(target) +
                                    " of this kind and would be replaced; remove it, or name another file");
    }
}

}  // namespace

void check_targets(const std::vector<ReportTarget>& reports) {
    const auto canonical = [](const fs::path& file) {
        std::error_code ignored;
        return fs::weakly_canonical(fs::absolute(file, ignored), ignored);
    };
    std::vector<fs::path> taken;
    for (const ReportTarget& target : reports) {
        if (!target.file) {
            continue;
        }
        check_target(target);
        const fs::path file = canonical(*target.file);
        for (const fs::path& other : taken) {
            if (file == other) {
                throw about(target, "another log or report goes here already; each needs a file of its own");
            }
        }
        taken.push_back(file);
    }
}

Reports::Reports(const std::vector<ReportTarget>& targets, const engine::ReportStyle& style, bool with_logs) {
    for (const ReportTarget& target : targets) {
        const bool is_log = target.name == "log";
        if (is_log && !with_logs) {
            continue;
        }
        LogOutput* output =
            outputs_
                .emplace_back(std::make_unique<LogOutput>(!target.file, target.file, target.name == "github"))
                .get();
        if (is_log) {
            logs_.push_back(output);
            continue;
        }
        engine::ReportStyle own = style;
        own.color = style.color && !target.file;
        reporters_.push_back(engine::make_reporter(
            target.name, [output](std::string_view text) { output->write(text); }, own));
        prints_outcomes_ = prints_outcomes_ || !target.file;
    }
}

void Reports::begin(const engine::RunPlan& plan) {
    for (const auto& reporter : reporters_) {
        reporter->begin(plan);
    }
}

void Reports::log(std::string_view lines) {
    for (LogOutput* output : logs_) {
        output->write(lines);
    }
}

void Reports::result(const engine::WalkResult& result) {
    for (const auto& reporter : reporters_) {
        reporter->result(result);
    }
    for (const auto& output : outputs_) {
        output->flush();  // what is known must not be lost with this process
    }
}

void Reports::end(const engine::RunReport& report) {
    for (const auto& reporter : reporters_) {
        reporter->end(report);
    }
    for (const auto& output : outputs_) {
        output->flush();
    }
}

}  // namespace campuswalk::tools
