#include "tools/campuswalk/run/plan/case_times.h"

#include <fstream>
#include <system_error>

#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/report_diagnostics.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

void add_case_times(const fs::path& file, CaseTimes& times) {
    std::error_code ignored;
    std::ifstream stream;
    if (fs::is_regular_file(file, ignored)) {
        stream.open(file, std::ios::binary);
    }
    if (!stream.is_open() || !stream) {
        throw error_about(file, "missing-file", "no such file, or it can't be read; check the path");
    }
    std::string line;
    for (int number = 1; std::getline(stream, line) && !stream.eof();
         ++number) {  // the last may be cut short
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        if (!json.is_object()) {
            throw scene::InputError(
                {file.generic_string(), number, 1}, "bad-times",
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
