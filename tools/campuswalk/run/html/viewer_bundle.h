#pragma once

#include "engine/html_report/html_page.h"

namespace campuswalk::tools {

/// The viewer that this program was built with (tools/viewer/).
const engine::ViewerBundle& viewer_bundle();

}  // namespace campuswalk::tools
