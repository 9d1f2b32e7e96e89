#include "tools/campuswalk/run/results/run_key.h"

#include <fcntl.h>
#include <sys/random.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <system_error>

#include "scene/cache/file_contents.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kVariable = "CAMPUSWALK_RUN_KEY";
constexpr std::size_t kKeyBytes = 32;

fs::path key_file(const Environment& environment) {
    // The XDG specification has relative paths ignored.
    fs::path states = environment("XDG_STATE_HOME").value_or("");
    if (!states.is_absolute()) {
        const fs::path home = environment("HOME").value_or("");
        states = home.is_absolute() ? home / ".local" / "state" : fs::path();
    }
    // A key that came with a checkout is anybody's.
    return states.empty() || !checkout_above(states, environment).empty() ? fs::path()
                                                                          : states / "campuswalk" / "run.key";
}

/// Empty if it isn't there, or if another user may have written it.
std::string read_key(const fs::path& file) {
    const std::optional<scene::FileContents> key = scene::FileContents::read_own(file);
    return key && key->bytes().size() == kKeyBytes
               ? std::string(reinterpret_cast<const char*>(key->bytes().data()), kKeyBytes)
               : "";
}

void make_key(const fs::path& file) {
    std::array<char, kKeyBytes> key{};
    if (getrandom(key.data(), key.size(), 0) != static_cast<ssize_t>(key.size())) {
        return;
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor >= 0) {  // otherwise another process was faster, or nothing can be written here
        const bool written = write(descriptor, key.data(), key.size()) == static_cast<ssize_t>(key.size());
        close(descriptor);
        if (!written) {
            fs::remove(file, ignored);
        }
    }
}

}  // namespace

std::optional<std::string> shared_run_key(const Environment& environment) {
    const std::optional<std::string> shared = environment(kVariable);
    constexpr std::size_t kMinCharacters = 16;
    if (shared && shared->size() < kMinCharacters) {
        throw error_about(kVariable, "bad-value",
                          "a key needs at least " + std::to_string(kMinCharacters) +
                              " characters; make one with: openssl rand -hex 32");
    }
    return shared;
}

std::string run_key(const Environment& environment) {
    if (const std::optional<std::string> shared = shared_run_key(environment)) {
        return *shared;
    }
    const fs::path file = key_file(environment);
    if (file.empty()) {
        return "";
    }
    if (std::error_code ignored; !fs::exists(file, ignored)) {
        make_key(file);
    }
    return read_key(file);
}

}  // namespace campuswalk::tools
