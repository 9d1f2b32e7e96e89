#include "tools/campuswalk/base/log_output.h"

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <spdlog/logger.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include "scene/base/new_file.h"
#include "tools/campuswalk/base/standard_streams.h"

namespace campuswalk::tools {

namespace {

/// spdlog's own file sink would write into a file that is there already.
class FileSink final : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
public:
    explicit FileSink(const std::filesystem::path& file)
        : file_(file),
          stream_(scene::is_stream(file) ? scene::open_stream(file)
                                         : scene::open_new_file(std::filesystem::weakly_canonical(file))) {}

private:
    void sink_it_(const spdlog::details::log_msg& message) override {
        spdlog::memory_buf_t text;
        formatter_->format(message, text);
        if (std::fwrite(text.data(), 1, text.size(), stream_.get()) != text.size()) {
            fail();
        }
    }
    void flush_() override {
        if (std::fflush(stream_.get()) != 0) {
            fail();
        }
    }
    [[noreturn]] void fail() const {
        throw std::runtime_error("can't write " + file_.string() + ": " +
                                 std::generic_category().message(errno));
    }

    std::filesystem::path file_;
    scene::FileStream stream_;
};

}  // namespace

LogOutput::LogOutput(bool to_terminal, const std::optional<std::filesystem::path>& file)
    : to_terminal_(to_terminal) {
    std::vector<spdlog::sink_ptr> sinks;
    if (to_terminal) {
        sinks.push_back(std::make_shared<spdlog::sinks::stdout_sink_st>());
    }
    if (file) {
        sinks.push_back(std::make_shared<FileSink>(*file));
    }
    logger_ = std::make_shared<spdlog::logger>("walk", sinks.begin(), sinks.end());
    logger_->set_formatter(
        std::make_unique<spdlog::pattern_formatter>("%v", spdlog::pattern_time_type::local, ""));
    // By default, spdlog prints the failure and continues.
    logger_->set_error_handler([](const std::string& reason) { throw std::runtime_error(reason); });
}

void LogOutput::write(std::string_view text) {
    logger_->info(text);
    if (to_terminal_) {
        check_standard_output();  // spdlog's terminal sink ignores failed writes
    }
}

void LogOutput::flush() {
    logger_->flush();
}

}  // namespace campuswalk::tools
