#include "tools/campuswalk/explore/earlier_files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <optional>
#include <vector>

#include "engine/render/plan/storey_plan.h"
#include "tools/campuswalk/base/json_text.h"

namespace campuswalk::tools::explore {

namespace fs = std::filesystem;

namespace {

/// The file's first bytes; empty unless it is a regular file and no link to one.
std::string beginning_of(const fs::path& file) {
    constexpr std::size_t kMost = 4096;
    std::error_code ignored;
    if (!fs::is_regular_file(fs::symlink_status(file, ignored))) {
        return "";
    }
    std::ifstream in(file, std::ios::binary);
    std::string bytes(kMost, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(kMost));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

bool is_untouched_walk(const std::string& text, const std::string& campus) {
    const std::string heading = "# Finding ";
    const std::size_t digits = std::min(text.find_first_not_of("0123456789", heading.size()), text.size());
    return text.starts_with(heading) && text.substr(digits).starts_with(kWalkHeading) &&
           text.find("\ncampus: " + json_text(campus) + "\n") != std::string::npos &&
           text.find("\nstatus: {is: xfail, because: ") != std::string::npos;
}

/// N of storey-N.png.
std::optional<std::size_t> storey_in(const std::string& name) {
    const std::string before = "storey-";
    const std::string behind = ".png";
    if (!name.starts_with(before) || !name.ends_with(behind) ||
        name.size() <= before.size() + behind.size() || name.size() > before.size() + behind.size() + 4) {
        return std::nullopt;
    }
    const std::string digits = name.substr(before.size(), name.size() - before.size() - behind.size());
    const bool is_number =
        std::ranges::all_of(digits, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
    return is_number ? std::optional<std::size_t>(std::stoul(digits)) : std::nullopt;
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
         it.increment(error)) {
        files.push_back(it->path());
    }
    return files;
}

}  // namespace

bool may_replace_walk(const fs::path& file, const std::string& campus) {
    std::error_code ignored;
    return !fs::exists(fs::symlink_status(file, ignored)) || is_untouched_walk(beginning_of(file), campus);
}

void remove_earlier_walks(const fs::path& folder, const std::string& campus,
                          const std::set<std::string>& written) {
    for (const fs::path& file : files_in(folder)) {
        const std::string name = file.filename().string();
        if (name.ends_with(".walk.yaml") && !written.contains(name) &&
            is_untouched_walk(beginning_of(file), campus)) {
            fs::remove(file);
        }
    }
}

void remove_earlier_plans(const fs::path& folder, std::size_t count) {
    for (const fs::path& file : files_in(folder)) {
        const std::optional<std::size_t> storey = storey_in(file.filename().string());
        if (storey && *storey >= count &&
            beginning_of(file).find(std::string("tEXtSoftware") + '\0' + engine::render::kPlanSoftware) !=
                std::string::npos) {
            fs::remove(file);
        }
    }
}

}  // namespace campuswalk::tools::explore
