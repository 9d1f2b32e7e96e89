#include "tools/campuswalk/loading/cache_choice.h"

#include <sys/mman.h>

#include <atomic>
#include <charconv>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <string_view>

#include "tools/campuswalk/base/environment.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/repository.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

bool disabled = false;

fs::path folder() {
    if (const auto own = environment_variable("CAMPUSWALK_CACHE_DIR")) {
        return *own;
    }
    // The XDG specification has relative paths ignored.
    if (const fs::path caches = environment_variable("XDG_CACHE_HOME").value_or(""); caches.is_absolute()) {
        return caches / "campuswalk";
    }
    const fs::path home = environment_variable("HOME").value_or("");
    return home.is_absolute() ? home / ".cache" / "campuswalk" : fs::path();
}

std::uint64_t max_bytes() {
    const std::string text = environment_variable("CAMPUSWALK_CACHE_SIZE").value_or("");
    if (text.empty()) {
        return scene::CacheFolder::kDefaultLimit;
    }
    constexpr std::uint64_t kMax = 1U << 20U;  // far from overflow in any unit
    std::uint64_t count = 0;
    const char* end = text.data() + text.size();
    const auto [unit, error] = std::from_chars(text.data(), end, count);
    const std::string_view rest(unit, static_cast<std::size_t>(end - unit));
    const std::optional<unsigned> shift = rest == "M"                  ? std::optional(20U)
                                          : rest == "G"                ? std::optional(30U)
                                          : rest.empty() && count == 0 ? std::optional(0U)
                                                                       : std::nullopt;
    if (error != std::errc() || !shift || count > kMax) {
        throw error_about("CAMPUSWALK_CACHE_SIZE", "bad-value",
                          "'" + text + "' isn't a size; use, for example, 500M or 8G, or 0 for no cache");
    }
    return count << *shift;
}

/// Shared with the processes that this one forks, so that only one of them warns.
std::atomic<bool>& warned() {
    static_assert(std::atomic<bool>::is_always_lock_free);
    static std::atomic<bool> own;
    static std::atomic<bool>& shared = [&]() -> std::atomic<bool>& {
        void* memory = mmap(nullptr, sizeof own, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        return memory == MAP_FAILED ? own : *new (memory) std::atomic<bool>();
    }();
    return shared;
}

/// A cache that can't be written isn't an error: only the time that the next start takes depends on it.
void warn_once(const std::string& reason) {
    if (!warned().exchange(true)) {
        diagnose({{scene::Severity::warning,
                   {},
                   "cache-unwritable",
                   "models are imported again each time: " + reason +
                       "; name another folder with CAMPUSWALK_CACHE_DIR, or use --no-cache"}});
    }
}

}  // namespace

const scene::CacheFolder* model_cache() {
    static const std::optional<scene::CacheFolder> cache = [] {
        const fs::path where = folder();
        const std::uint64_t size = disabled || where.empty() ? 0 : max_bytes();
        if (size == 0) {
            return std::optional<scene::CacheFolder>();
        }
        if (const fs::path checkout = checkout_above(where, environment_variable); !checkout.empty()) {
            warn_once("'" + where.string() + "' is in the project '" + checkout.filename().string() +
                      "', whose files could replace it");
            return std::optional<scene::CacheFolder>();
        }
        return std::optional(scene::CacheFolder(where, size, warn_once));
    }();
    return cache ? &*cache : nullptr;
}

void add_cache_flag(Command command) {
    warned();  // before there are other processes
    command.flag({.names = "--no-cache",
                  .help = "Neither read nor write the model cache; see CAMPUSWALK_CACHE_DIR and "
                          "CAMPUSWALK_CACHE_SIZE (such as 8G)"},
                 [] { disabled = true; });
}

}  // namespace campuswalk::tools
