#include "tools/campuswalk/base/log_output.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <spdlog/logger.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include "engine/report/plain_text.h"
#include "tools/campuswalk/base/standard_streams.h"

namespace campuswalk::tools {

LogOutput::LogOutput(bool to_terminal, const std::optional<std::filesystem::path>& file, bool commands)
    : to_terminal_(to_terminal), commands_(commands) {
    std::vector<spdlog::sink_ptr> sinks;
    if (to_terminal) {
        sinks.push_back(std::make_shared<spdlog::sinks::stdout_sink_st>());
    }
    if (file) {
        sinks.push_back(std::make_shared<spdlog::sinks::basic_file_sink_st>(file->string(), true));
    }
    logger_ = std::make_shared<spdlog::logger>("walk", sinks.begin(), sinks.end());
    logger_->set_formatter(
        std::make_unique<spdlog::pattern_formatter>("%v", spdlog::pattern_time_type::local, ""));
    // By default, spdlog prints the failure and continues.
    logger_->set_error_handler([](const std::string& reason) { throw std::runtime_error(reason); });
}

void LogOutput::write(std::string_view text) {
    if (to_terminal_ && !commands_) {
        logger_->info(engine::without_ci_commands(text));
    } else {
        logger_->info(text);
    }
    if (to_terminal_) {
        check_standard_output();  // spdlog's terminal sink ignores failed writes
    }
}

void LogOutput::flush() {
    logger_->flush();
}

}  // namespace campuswalk::tools
