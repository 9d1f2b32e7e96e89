#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "config/loader/checked_node.h"

namespace campuswalk::config {

/// A YAML file in memory; CheckedNodes point into it.
class YamlFile {
public:
    /// Reads and parses; null after complaining. `asked_at` is where another file names this one
    /// ({file, 0, 0} when the user did).
    static std::unique_ptr<YamlFile> open(const std::filesystem::path& path,
                                          const scene::SourceMark& asked_at,
                                          scene::DiagnosticList& diagnostics);

    CheckedNode root() const { return {*root_, "the file", file_, *diagnostics_}; }
    /// Stands for the whole file.
    scene::SourceMark mark() const { return {file_, 0, 0}; }

private:
    YamlFile() = default;

    std::string file_;
    std::shared_ptr<const YamlNode> root_;
    scene::DiagnosticList* diagnostics_ = nullptr;
};

/// NAME of `NAME.walk.yaml` for the suffix ".walk.yaml". Names stand in logs and become file names, so they
/// have no spaces; anything else is complained of (file-name, at `asked_at`).
std::string name_from_file(const std::filesystem::path& path, const std::string& suffix,
                           const scene::SourceMark& asked_at, scene::DiagnosticList& diagnostics);

}  // namespace campuswalk::config
