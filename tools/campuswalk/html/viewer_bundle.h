#pragma once

#include "engine/report/html/html_page.h"

namespace campuswalk::tools {

/// The viewer that this program was built with (tools/viewer/).
const engine::ViewerBundle& viewer_bundle();

}  // namespace campuswalk::tools
