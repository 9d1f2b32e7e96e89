#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "config/loader/load_campus.h"
#include "config/loader/load_run.h"
#include "tests/support/temporary_folder.h"

namespace campuswalk::config::test {

using Lines = std::vector<std::string>;

/// A folder with a small campus (a.campus.yaml), a profile (avatars/adult.avatar.yaml) and a walk
/// (a.walk.yaml) that load without a diagnostic; tests replace one of the files.
class ConfigFolder {
public:
    ConfigFolder();

    void write(const std::string& name, std::string_view text) const { folder_.write(name, text); }
    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

    Run run() const { return load_run(path("a.walk.yaml"), {}); }
    scene::CampusDescription campus() const { return load_campus_description(path("a.campus.yaml")); }

    /// The diagnostics of a text written to that file, one per line, paths relative to the folder; empty when
    /// it loads.
    Lines about_campus(std::string_view text) const;
    Lines about_avatar(std::string_view text) const;
    Lines about_walk(std::string_view text) const;
    /// The diagnostics of the files as they are.
    Lines about_run() const;

    // The same for a part of a file whose other lines are valid.

    /// List entries of `steps`, from line 3 on.
    Lines about_steps(const std::string& text) const;
    /// List entries of `expect`, from line 4 on.
    Lines about_expectations(const std::string& text) const;
    /// One of `colliders`, from line 5 and column 5 on.
    Lines about_collider(const std::string& text) const;

private:
    Lines formatted_diagnostics_of(const std::function<void()>& load) const;

    support::TemporaryFolder folder_;
};

/// The diagnostics that `load` throws; none when it doesn't.
std::vector<scene::Diagnostic> diagnostics_of(const std::function<void()>& load);

}  // namespace campuswalk::config::test
