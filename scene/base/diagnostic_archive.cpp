#include "scene/base/diagnostic_archive.h"

#include <optional>

namespace campuswalk::scene {

void put(ArchiveWriter& out, const SourceMark& mark) {
    out.put_text(mark.file);
    out.put(std::int32_t{mark.line});
    out.put(std::int32_t{mark.column});
}

void put(ArchiveWriter& out, const Diagnostic& diagnostic) {
    out.put(static_cast<std::uint32_t>(diagnostic.severity));
    put(out, diagnostic.mark);
    out.put_text(diagnostic.code.text());
    out.put_text(diagnostic.message);
}

SourceMark take_mark(ArchiveReader& in) {
    SourceMark mark;
    mark.file = in.take_text();
    mark.line = in.take<std::int32_t>();
    mark.column = in.take<std::int32_t>();
    return mark;
}

Diagnostic take_diagnostic(ArchiveReader& in) {
    Diagnostic diagnostic;
    diagnostic.severity = static_cast<Severity>(in.take_below(2, "severity"));
    diagnostic.mark = take_mark(in);
    const std::optional<DiagnosticCode> code = DiagnosticCode::find(in.take_text());
    if (!code) {
        throw DamagedFile("a diagnostic's code is unknown");
    }
    diagnostic.code = *code;
    diagnostic.message = in.take_text();
    return diagnostic;
}

}  // namespace campuswalk::scene
