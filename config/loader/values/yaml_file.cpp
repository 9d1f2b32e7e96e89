#include "config/loader/values/yaml_file.h"

#include <algorithm>
#include <optional>
#include <system_error>

#include "config/loader/yaml/source_text.h"
#include "config/loader/yaml/wording.h"
#include "scene/base/ascii.h"

namespace campuswalk::config {

using scene::DiagnosticList;
using scene::SourceMark;

namespace {

bool is_name_character(char c) {
    return scene::is_letter(c) || scene::is_digit(c) || c == '-' || c == '_' || c == '.' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// NAME of `NAME.walk.yaml`; nullopt if the file has another suffix and so is probably another kind of file.
std::optional<std::string> name_from(const std::string& file_name, const std::string& suffix,
                                     const SourceMark& named_at, DiagnosticList& diagnostics) {
    if (!file_name.ends_with(suffix) || file_name.size() == suffix.size()) {
        diagnostics.error(
            named_at, "file-name",
            in_quotes(file_name) + " must be named NAME" + suffix + "; rename it, or name another file");
        return std::nullopt;
    }
    std::string name = file_name.substr(0, file_name.size() - suffix.size());
    if (name.front() == '.' || !std::ranges::all_of(name, is_name_character)) {
        diagnostics.error(named_at, "file-name",
                          in_quotes(file_name) + ": NAME" + suffix +
                              " may have letters, digits, '-', '_' and, except at its start, '.'; rename it");
    }
    return name;
}

}  // namespace

std::unique_ptr<YamlFile> YamlFile::open(const std::filesystem::path& path, const std::string& suffix,
                                         const ReadRoots& roots, const SourceMark& named_at,
                                         DiagnosticList& diagnostics) {
    if (const std::string why = roots.why_unreadable(path); !why.empty()) {
        diagnostics.error(named_at, "outside-project", in_quotes(shown_path(path)) + " " + why);
        return nullptr;
    }
    std::unique_ptr<YamlFile> file(new YamlFile());
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {  // otherwise read_source reports it
        const auto name = name_from(path.filename().generic_string(), suffix, named_at, diagnostics);
        if (!name) {
            return nullptr;
        }
        file->name_ = *name;
    }
    const std::optional<std::string> text = read_source(path, named_at, diagnostics);
    if (!text) {
        return nullptr;
    }
    file->file_ = shown_path(path);
    if (!roots.budget().admit(*text, file->file_, diagnostics)) {
        return nullptr;
    }
    file->diagnostics_ = &diagnostics;
    file->root_ = parse_yaml(*text, file->file_, diagnostics);
    return file->root_ ? std::move(file) : nullptr;
}

}  // namespace campuswalk::config
