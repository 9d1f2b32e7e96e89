#pragma once

#include <string>
#include <vector>

#include "engine/walkspace/report/walk_report.h"
#include "scene/campus/campus.h"
#include "tools/campuswalk/explore/findings.h"

namespace campuswalk::tools::explore {

/// The report as a GeoJSON FeatureCollection (RFC 7946) for maps: the ground of each storey as a
/// MultiPolygon, subjects and findings as Points with their heights. Longitude and latitude if the campus
/// states where on Earth it is, +X pointing east and -Z north; else metres, [x, -z], which the member
/// `coordinates` says.
std::string report_geojson(const scene::Campus& campus, const engine::WalkReport& report,
                           const std::vector<Finding>& findings);

}  // namespace campuswalk::tools::explore
