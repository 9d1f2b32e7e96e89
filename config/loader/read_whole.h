#pragma once

#include <filesystem>
#include <string>
#include <type_traits>

#include "config/loader/search_paths.h"
#include "config/loader/values/checked_node.h"
#include "config/loader/yaml/diagnostics.h"
#include "config/loader/yaml/source_text.h"
#include "config/loader/yaml/yaml_tree.h"

namespace campuswalk::config {

/// Returns what `read` makes of a file that the user names, given the folders it may read from, the mark of
/// the file and the list for its diagnostics; throws all errors in that list together.
template <typename Read>
auto read_whole_file(const std::filesystem::path& file, const SearchPaths& search, const Read& read) {
    scene::DiagnosticList diagnostics;
    const scene::SourceMark mark{shown_path(file), 0, 0};
    auto result = read(read_roots(file, search), mark, diagnostics);
    throw_in_order(diagnostics, mark);
    return result;
}

/// Returns what `read` makes of a YAML text, which diagnostics call `what`, in `source`.
template <typename Read>
auto read_whole_text(const std::string& text, const std::string& source, const std::string& what,
                     const Read& read) {
    scene::DiagnosticList diagnostics;
    std::invoke_result_t<const Read&, const CheckedNode&> result = {};
    if (const auto root = parse_yaml(text, source, diagnostics)) {
        result = read(CheckedNode(*root, what, source, diagnostics));
    }
    throw_in_order(diagnostics, {source, 0, 0});
    return result;
}

}  // namespace campuswalk::config
