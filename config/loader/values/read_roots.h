#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/loader/yaml/read_budget.h"

namespace campuswalk::config {

/// The folders whose files a project may name, and how much may be read of them. Files come from strangers:
/// without such a limit, a campus could show any picture of this machine, and an error in YAML quote any
/// text.
class ReadRoots {
public:
    /// The project of a file that the user names, and more folders, which need not exist. The project is the
    /// folder of walks.config.yaml or the repository (`.git`), whichever is nearer above the file; without
    /// them the current folder if the file is below it, else the file's folder.
    ReadRoots(const std::filesystem::path& file, const std::vector<std::filesystem::path>& more,
              std::shared_ptr<ReadBudget> budget = std::make_shared<ReadBudget>());

    /// Why the file may not be read: followed to the end of its symbolic links, it must be below a root and
    /// not in a folder like `.git`. Empty if it may, or if it doesn't exist in a place where it might.
    std::string why_unreadable(const std::filesystem::path& file) const;
    /// The same of a canonical path: nothing is followed.
    std::string why_canonical_unreadable(const std::filesystem::path& file) const;

    const std::filesystem::path& project() const { return roots_.front(); }
    std::span<const std::filesystem::path> others() const { return std::span(roots_).subspan(1); }
    ReadBudget& budget() const { return *budget_; }

private:
    std::vector<std::filesystem::path> roots_;  ///< canonical; the project first
    std::shared_ptr<ReadBudget> budget_;
};

}  // namespace campuswalk::config
