#include "tools/campuswalk/base/report_diagnostics.h"
#include "tools/campuswalk/run/html/html_reports.h"

namespace campuswalk::tools {

void require_html_reports(const std::filesystem::path& subject) {
    throw error_about(
        subject, "not-built",
        "this build writes no HTML reports: run tools/setup-report, or configure with CAMPUSWALK_HTML=ON");
}

void write_campus_bundles(const std::filesystem::path&, const CampusesByFile&, ReportGeometry) {}

std::unique_ptr<engine::Reporter> make_html_reporter(const HtmlRequest& request, engine::TextSink) {
    require_html_reports(request.output);
    return nullptr;
}

}  // namespace campuswalk::tools
