#include "tools/campuswalk/run/output/output_folder.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "scene/base/atomic_file.h"
#include "scene/base/diagnostic.h"
#include "tools/campuswalk/base/json_text.h"
#include "tools/campuswalk/base/read_lines.h"
#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/base/walk_folder.h"
#include "tools/campuswalk/run/results/signed_line.h"

namespace campuswalk::tools {

namespace fs = std::filesystem;

namespace {

constexpr const char* kListBegin = ".written";
constexpr const char* kListEnd = ".json";
constexpr const char* kFiles = "written";
constexpr std::string_view kContext = "campuswalk written files";
constexpr std::uintmax_t kMaxListBytes = std::uintmax_t{1} << 28U;

fs::path list_file(int shard) {
    return kListBegin + (shard == 1 ? "" : "-" + std::to_string(shard)) + kListEnd;
}

bool is_list(const fs::path& path) {
    const std::string name = path.native();  // in the folder itself, not below
    return name.starts_with(kListBegin) && name.ends_with(kListEnd) && !path.has_parent_path();
}

std::string time_text(const timespec& time) {
    return std::to_string(time.tv_sec) + "." + std::to_string(time.tv_nsec);
}

/// A file that is replaced or changed gets another one. Nobody can set the time of the status change.
std::string identity_of(const struct stat& status) {
    return std::to_string(status.st_ino) + " " + std::to_string(status.st_size) + " " +
           time_text(status.st_mtim) + " " + time_text(status.st_ctim);
}

bool is_below(const fs::path& path, const fs::path& folder) {
    return std::ranges::mismatch(folder, path).in1 == folder.end();
}

const char* kind_of(const struct stat& status) {
    return S_ISLNK(status.st_mode)    ? "a symbolic link"
           : S_ISFIFO(status.st_mode) ? "a pipe"
           : S_ISSOCK(status.st_mode) ? "a socket"
                                      : "a device";
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, std::string key, const Tolerance& tolerance)
    : folder_(std::move(folder)), key_(std::move(key)), before_(scanned()), known_(listed(before_)) {
    for (const auto& [name, identity] : before_) {
        const fs::path& path = name;  // clang 14 captures no structured binding
        const bool tolerated =
            tolerance.all || known_.contains(path) ||
            (tolerance.temporaries && scene::is_temporary(path.filename().native())) ||
            std::ranges::any_of(tolerance.paths,
                                [&](const fs::path& each) { return is_below(path, each); }) ||
            (is_list(path) && is_authentic_list(path));
        if (!tolerated) {
            throw error_about(
                folder_ / path, "foreign-output",
                std::string(
                    "no list of your runs names this file as it is, and where CI is set, what came ") +
                    "with a checkout isn't taken for output; " +
                    (key_.empty() ? "lists need CAMPUSWALK_RUN_KEY, or a HOME outside of the checkout; "
                                  : "if a run was killed, continue it with --resume; else ") +
                    "remove the file, or choose an --output of your own");
        }
    }
}

OutputFolder::Files OutputFolder::scanned() const {
    Files files;
    walk_folder(folder_, [&](const fs::directory_entry& entry) {
        struct stat status {};
        if (lstat(entry.path().c_str(), &status) != 0) {
            if (errno == ENOENT) {
                return false;  // another shard's temporary file, renamed meanwhile
            }
            throw error_about(entry.path(), "output-unwritable",
                              "it can't be looked at: " + std::generic_category().message(errno));
        }
        if (S_ISREG(status.st_mode)) {
            files[entry.path().lexically_relative(folder_)] = identity_of(status);
        } else if (!S_ISDIR(status.st_mode)) {
            throw error_about(
                entry.path(), "output-unwritable",
                std::string("this is ") + kind_of(status) +
                    ", and in an output folder there may be only files and folders; remove it, or "
                    "choose another --output");
        }
        return true;
    });
    return files;
}

bool OutputFolder::is_authentic_list(const fs::path& file) const {
    std::error_code ignored;
    return fs::file_size(folder_ / file, ignored) <= kMaxListBytes &&
           is_authentic(read_bytes(folder_ / file), kContext, key_);
}

OutputFolder::Files OutputFolder::listed(const Files& present) const {
    Files known;
    for (const auto& [path, identity] : present) {
        if (!is_list(path) || !is_authentic_list(path)) {
            continue;
        }
        const Json list = Json::parse(unsigned_line(read_bytes(folder_ / path)));
        for (const auto& [name, listed] : list.at(kFiles).items()) {
            const auto found = present.find(fs::path(name));
            if (found != present.end() && listed == found->second) {
                known.insert(*found);
            }
        }
    }
    return known;
}

void OutputFolder::save_list(int shard) const {
    std::error_code ignored;
    if (key_.empty() || !fs::is_directory(folder_, ignored)) {
        return;
    }
    Json files = Json::object();
    for (const auto& [path, identity] : scanned()) {
        const auto earlier = before_.find(path);
        const bool is_new = earlier == before_.end() || earlier->second != identity;
        if (!is_list(path) && (is_new || known_.contains(path))) {
            files[path.generic_string()] = identity;
        }
    }
    if (files.empty()) {
        return;
    }
    scene::write_file_atomically(folder_ / list_file(shard),
                                 signed_line(json_text({{kFiles, std::move(files)}}), kContext, key_));
}

}  // namespace campuswalk::tools
