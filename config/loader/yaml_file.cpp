#include "config/loader/yaml_file.h"

#include <algorithm>

#include "config/loader/source_text.h"
#include "config/loader/wording.h"

namespace campuswalk::config {

std::unique_ptr<YamlFile> YamlFile::open(const std::filesystem::path& path, const scene::SourceMark& asked_at,
                                         scene::DiagnosticList& diagnostics) {
    const std::optional<std::string> text = read_source(path, asked_at, diagnostics);
    if (!text) {
        return nullptr;
    }
    std::unique_ptr<YamlFile> file(new YamlFile());
    file->file_ = shown_path(path);
    file->diagnostics_ = &diagnostics;
    file->root_ = parse_yaml(*text, file->file_, diagnostics);
    return file->root_ ? std::move(file) : nullptr;
}

std::string name_from_file(const std::filesystem::path& path, const std::string& suffix,
                           const scene::SourceMark& asked_at, scene::DiagnosticList& diagnostics) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_' || c == '.' || static_cast<unsigned char>(c) >= 0x80;
    };
    const std::string file_name = path.filename().generic_string();
    if (!file_name.ends_with(suffix) || file_name.size() == suffix.size()) {
        diagnostics.error(asked_at, "file-name", in_quotes(file_name) + ": rename the file to NAME" + suffix);
        return "";
    }
    std::string name = file_name.substr(0, file_name.size() - suffix.size());
    if (!std::ranges::all_of(name, allowed)) {
        diagnostics.error(asked_at, "file-name",
                          in_quotes(file_name) + ": rename the file; NAME" + suffix +
                              " takes letters, digits, '-', '_' and '.'");
    }
    return name;
}

}  // namespace campuswalk::config
