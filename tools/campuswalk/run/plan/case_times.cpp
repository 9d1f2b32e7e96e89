#include "tools/campuswalk/run/plan/case_times.h"

#include "scene/base/diagnostic.h"
#include "scene/base/json_limits.h"
#include "tools/campuswalk/base/file_lines.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

void add_case_times(const fs::path& file, CaseTimes& times) {
    FileLines lines(file);
    while (const auto line = lines.next()) {
        const auto json = scene::why_too_complex(*line).empty() ? Json::parse(*line, nullptr, false) : Json();
        if (!json.is_object()) {
            throw scene::InputError(
                {file.generic_string(), lines.number(), 1}, "bad-times",
                "this isn't a line of JSON with a case's id and microseconds; name a run's "
                "last-run.jsonl");
        }
        const auto id = json.find("id");
        const auto taken = json.find(kMicroseconds);
        if (id != json.end() && id->is_string() && taken != json.end() && taken->is_number_unsigned()) {
            times[id->get<std::string>()] = taken->get<std::uint64_t>();
        }
    }
}

std::string to_json_lines(const CaseTimes& times) {
    std::string lines;
    for (const auto& [id, microseconds] : times) {
        lines += json_text({{"id", id}, {kMicroseconds, microseconds}}) + "\n";
    }
    return lines;
}

}  // namespace campuswalk::tools
