#include "tools/campuswalk/validate/findings.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "engine/report/github_text.h"
#include "engine/report/report_paths.h"
#include "scene/base/ascii.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/run/plan/find_walks.h"

namespace campuswalk::tools {

using scene::Diagnostic;
using scene::Severity;

namespace {

const char* level_of(const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::error ? "error" : "warning";
}

bool is_unescaped_in_uri(char c) {
    return scene::is_letter(c) || scene::is_digit(c) ||
           std::string_view("-._~/").find(c) != std::string_view::npos;
}

std::string uri_of(std::string_view path) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        if (is_unescaped_in_uri(c)) {
            uri += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            uri += {'%', kDigits[byte / 16U], kDigits[byte % 16U]};
        }
    }
    return uri;
}

Json sarif_result(const Diagnostic& diagnostic, const std::vector<std::string_view>& codes) {
    Json place = {{"artifactLocation", {{"uri", uri_of(diagnostic.mark.file)}}}};
    if (diagnostic.mark.line > 0) {
        place["region"] = {{"startLine", diagnostic.mark.line},
                           {"startColumn", std::max(1, diagnostic.mark.column)}};
    }
    return {{"ruleId", diagnostic.code.text()},
            {"ruleIndex", std::ranges::find(codes, diagnostic.code.text()) - codes.begin()},
            {"level", level_of(diagnostic)},
            {"message", {{"text", diagnostic.message}}},
            {"locations", Json::array({{{"physicalLocation", std::move(place)}}})}};
}

std::vector<std::string_view> codes_of(const Findings& findings) {
    std::vector<std::string_view> codes;
    for (const Diagnostic& diagnostic : findings.diagnostics) {
        codes.push_back(diagnostic.code.text());
    }
    std::ranges::sort(codes);
    codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
    return codes;
}

}  // namespace

Findings with_paths_in_repository(const std::string& start, Findings findings) {
    const auto placed = [&](const std::string& path) {
        return engine::path_in_repository(start, as_seen_from_here(path).generic_string());
    };
    for (CheckedFile& checked : findings.files) {
        checked.file = placed(checked.file);
    }
    for (Diagnostic& diagnostic : findings.diagnostics) {
        diagnostic.mark.file = placed(diagnostic.mark.file);
    }
    return findings;
}

std::string as_json(const Findings& findings) {
    Json files = Json::array();
    for (const CheckedFile& file : findings.files) {
        files.push_back({{"file", file.file}, {"valid", file.valid}});
        if (file.valid) {
            files.back()["summary"] = file.summary;
        }
    }
    Json diagnostics = Json::array();
    for (const Diagnostic& diagnostic : findings.diagnostics) {
        Json entry = {{"file", diagnostic.mark.file}};
        if (diagnostic.mark.line > 0) {
            entry["line"] = diagnostic.mark.line;
            entry["column"] = diagnostic.mark.column;
        }
        entry["severity"] = level_of(diagnostic);
        entry["code"] = diagnostic.code.text();
        entry["message"] = diagnostic.message;
        diagnostics.push_back(std::move(entry));
    }
    return json_text({{"version", 1}, {"files", std::move(files)}, {"diagnostics", std::move(diagnostics)}},
                     2) +
           "\n";
}

std::string as_sarif(const Findings& findings) {
    const std::vector<std::string_view> codes = codes_of(findings);
    Json rules = Json::array();
    for (const std::string_view code : codes) {
        rules.push_back({{"id", code}});
    }
    Json results = Json::array();
    for (const Diagnostic& diagnostic : findings.diagnostics) {
        results.push_back(sarif_result(diagnostic, codes));
    }
    const Json driver = {
        {"name", "campuswalk"}, {"version", CAMPUSWALK_VERSION}, {"rules", std::move(rules)}};
    const Json run = {
        {"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", std::move(results)}};
    const Json sarif = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                        {"version", "2.1.0"},
                        {"runs", Json::array({run})}};
    return json_text(sarif, 2) + "\n";
}

std::string as_github(const Findings& findings) {
    std::string lines;
    for (const Diagnostic& diagnostic : findings.diagnostics) {
        lines += std::string("::") + level_of(diagnostic) +
                 " file=" + engine::github_escaped(diagnostic.mark.file, true);
        if (diagnostic.mark.line > 0) {
            lines += ",line=" + std::to_string(diagnostic.mark.line) +
                     ",col=" + std::to_string(diagnostic.mark.column);
        }
        lines += ",title=" + engine::github_escaped(std::string(diagnostic.code.text()), true) +
                 "::" + engine::github_escaped(diagnostic.message, false) + "\n";
    }
    return lines;
}

}  // namespace campuswalk::tools
