#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace campuswalk::tools {

/// In an output folder: what html reports show of campuses.
inline constexpr const char* kBundleFolder = "campuses";

/// The folder that a run writes to. A checkout can bring files and links there: a link would lead what is
/// written or uploaded elsewhere, and a file would be taken for one that the run has written.
///
/// Lists of what runs have written are files in the folder, signed with the user's key (run_key.h). They hold
/// of each file what the file system tells of its identity, so that no copy and no later version passes for
/// it.
class OutputFolder {
public:
    /// What may be in the folder besides what the lists name.
    struct Tolerance {
        bool all = false;          ///< any regular file
        bool temporaries = false;  ///< those of a process that was killed (scene::AtomicFile)
        /// Files and folders, relative to the folder: what an interrupted run, or processes that work at the
        /// same time, may have left there.
        std::vector<std::filesystem::path> paths;
    };

    /// Looks through the folder, which need not exist. Throws scene::InputError:
    ///   output-unwritable  what is neither a file nor a folder, such as a link
    ///   folder-unreadable  a folder whose contents can't be listed
    ///   foreign-output     a file that is on no list of this user's runs and isn't tolerated
    OutputFolder(std::filesystem::path folder, std::string key, const Tolerance& tolerance);

    /// Lists what has been written since, and what earlier lists name and is unchanged, under the name of
    /// this shard. Nothing without a key. Throws std::runtime_error if the list can't be written.
    void save_list(int shard) const;

private:
    /// By path relative to the folder: inode, size, times of modification and status change.
    using Files = std::map<std::filesystem::path, std::string>;

    Files scanned() const;
    Files listed(const Files& present) const;
    bool is_authentic_list(const std::filesystem::path& file) const;

    std::filesystem::path folder_;
    std::string key_;
    Files before_;  ///< what was there
    Files known_;   ///< of these, what lists name
};

}  // namespace campuswalk::tools
