#include "tools/campuswalk/run/results/reports.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <span>
#include <system_error>

#include "scene/base/new_file.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/writable_path.h"
#include "tools/campuswalk/run/results/result_file.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

scene::DiagnosticCode code_for(const ReportTarget& target) {
    return target.name == "log" || target.name == "jsonl-log" ? scene::DiagnosticCode("log-unwritable")
                                                              : "report-unwritable";
}

scene::InputError about(const ReportTarget& target, const std::string& message) {
    return error_about(*target.file, code_for(target), message);
}

std::string noun(const ReportTarget& target) {
    return code_for(target) == "log-unwritable" ? "log" : "report";
}

/// Whether a file begins like a report of this kind, or is empty.
bool begins_like(std::string_view kind, const fs::path& file) {
    const std::map<std::string_view, std::vector<std::string_view>> beginnings = {
        {"list", {"pass  ", "FAIL  ", "skip  ", "xfail ", "STOP  ", "ERROR "}},
        {"junit", {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"campuswalk\""}},
        {"tap", {"TAP version 14"}},
        {"json", {"{\"campuswalk_report\":"}},
        {"jsonl", {"{\"campuswalk_results\":", "{\"code\":\""}},
        {"github", {"::error ", "::notice title=campuswalk::"}},
        {"markdown", {"## campuswalk: "}},
        {"html",
         {"<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\">\n"
          "<meta http-equiv=\"Content-Security-Policy\""}},
        {"log", {"# walk-log "}}};
    constexpr std::size_t kEnough = 128;  // characters: the longest has 102
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
    if (!target.configured && !leads_through_link(*target.file) && scene::is_stream(*target.file)) {
        return;  // the user knows who reads it
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

/// Signs what the jsonl reporter writes: a line at a time, the header first.
engine::TextSink signing(engine::TextSink sink, const std::string& key) {
    return [sink = std::move(sink), key, header = std::string()](std::string_view line) mutable {
        const std::string object(line.substr(0, line.size() - 1));
        sink(report_line(object, header, key) + "\n");
        header = header.empty() ? object : header;
    };
}

/// Whether a reader needs the report's end to make sense of it. A file whose folder can't be changed is
/// written like a stream.
bool is_whole(const ReportTarget& target) {
    constexpr std::array<std::string_view, 4> kWhole = {"junit", "json", "html", "markdown"};
    if (std::ranges::find(kWhole, target.name) == kWhole.end()) {
        return false;
    }
    std::error_code ignored;
    return !scene::is_stream(*target.file) &&
           (!fs::exists(*target.file, ignored) || why_folder_unwritable(target.file->parent_path()).empty());
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

Reports::Reports(const std::vector<ReportTarget>& targets, const engine::ReportStyle& style, bool with_logs,
                 const std::optional<std::string>& key) {
    for (const ReportTarget& target : targets) {
        if (target.name != "log") {
            engine::ReportStyle own = style;
            own.color = style.color && !target.file;
            reporters_.push_back(engine::make_reporter(target.name, sink_for(target, key), own));
            prints_outcomes_ = prints_outcomes_ || !target.file;
        } else if (with_logs) {
            outputs_.push_back(std::make_unique<LogOutput>(!target.file, target.file));
            logs_.push_back(outputs_.back().get());
        }
    }
}

engine::TextSink Reports::sink_for(const ReportTarget& target, const std::optional<std::string>& key) {
    if (target.file && is_whole(target)) {
        outdated_.push_back(fs::weakly_canonical(*target.file));
        whole_files_.push_back(std::make_unique<scene::AtomicFile>(outdated_.back()));
        return [file = whole_files_.back().get()](std::string_view text) {
            file->write(std::as_bytes(std::span(text)));
        };
    }
    outputs_.push_back(std::make_unique<LogOutput>(!target.file, target.file));
    const engine::TextSink sink = [output = outputs_.back().get()](std::string_view text) {
        output->write(text);
    };
    return target.name == "jsonl" && key ? signing(sink, *key) : sink;
}

void Reports::begin(const engine::RunPlan& plan) {
    for (const fs::path& file : outdated_) {
        fs::remove(file);
    }
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

void Reports::end(const engine::ResultSequence& results) {
    for (const auto& reporter : reporters_) {
        reporter->end(results);
    }
    for (const auto& output : outputs_) {
        output->flush();
    }
    for (const auto& file : whole_files_) {
        file->finish();
    }
}

}  // namespace campuswalk::tools
