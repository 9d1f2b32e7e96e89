#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "config/loader/values/checked_node.h"
#include "config/loader/values/read_roots.h"

namespace campuswalk::config {

/// A YAML file in memory; CheckedNodes point into it.
class YamlFile {
public:
    /// Reads and parses `NAME.walk.yaml` for the suffix ".walk.yaml"; null after reporting an error.
    /// `named_at` is where another file names this one ({file, 0, 0} if the user did); diagnostics about the
    /// name (file-name) and the place (outside-project) are reported there.
    static std::unique_ptr<YamlFile> open(const std::filesystem::path& path, const std::string& suffix,
                                          const ReadRoots& roots, const scene::SourceMark& named_at,
                                          scene::DiagnosticList& diagnostics);

    /// The file's name without the suffix. Names appear in logs and become file names, so they have no
    /// spaces.
    const std::string& name() const { return name_; }
    CheckedNode root() const { return {*root_, "the file", file_, *diagnostics_}; }
    /// Marks the whole file.
    scene::SourceMark mark() const { return {file_, 0, 0}; }

private:
    YamlFile() = default;

    std::string name_;
    std::string file_;
    std::shared_ptr<const YamlNode> root_;
    scene::DiagnosticList* diagnostics_ = nullptr;
};

}  // namespace campuswalk::config
