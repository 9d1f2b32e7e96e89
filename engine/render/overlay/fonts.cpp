#include <array>
#include <string>

#include <fontconfig/fontconfig.h>
#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>

#include "engine/render/gl/render_error.h"
#include "engine/render/overlay/canvas.h"
#include "scene/base/installation.h"

namespace campuswalk::engine::render {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFiles = {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "wqy-microhei.ttc"};

bool add_font(FcConfig* config, std::span<const fs::path> folders, const char* file) {
    for (const fs::path& folder : folders) {
        const fs::path path = folder / file;
        std::error_code error;
        if (fs::exists(path, error) &&
            FcConfigAppFontAddFile(config, reinterpret_cast<const FcChar8*>(path.c_str())) == FcTrue) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::span<const fs::path> Fonts::default_folders() {
    static const std::array<fs::path, 8> folders = {
        scene::installed_data() / "fonts",         "/usr/share/fonts/truetype/dejavu",
        "/usr/share/fonts/truetype/wqy",           "/usr/share/fonts/dejavu-sans-fonts",
        "/usr/share/fonts/wqy-microhei-fonts",     "/usr/share/fonts/TTF",
        "/usr/share/fonts/wenquanyi/wqy-microhei", "/usr/share/fonts/truetype",
    };
    return folders;
}

Fonts::Fonts(std::span<const fs::path> folders) {
    FcConfig* config = FcConfigCreate();
    for (const char* file : kFiles) {
        if (!add_font(config, folders, file)) {
            FcConfigDestroy(config);
            throw RenderError(
                std::string("pictures need the fonts DejaVu Sans and WenQuanYi Micro Hei, but ") + file +
                " is missing: install them (Debian, Ubuntu: apt install fonts-dejavu-core "
                "fonts-wqy-microhei; Fedora: dnf install dejavu-sans-fonts wqy-microhei-fonts)");
        }
    }
    // Pango would load the system's configuration, which isn't used, takes time, and is missing on some
    // machines.
    FcConfigSetCurrent(config);
    PangoFontMap* map = pango_cairo_font_map_new_for_font_type(CAIRO_FONT_TYPE_FT);
    pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(map), config);
    FcConfigDestroy(config);  // the map holds its own reference
    context_.reset(pango_font_map_create_context(map));
    g_object_unref(map);

    // Independent of the user's locale, which also selects fonts.
    pango_context_set_language(context_.get(), pango_language_from_string("en"));
    pango_context_set_round_glyph_positions(context_.get(), FALSE);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context_.get(), options);
    cairo_font_options_destroy(options);
}

void Fonts::Release::operator()(_PangoContext* context) const {
    g_object_unref(context);
}

}  // namespace campuswalk::engine::render
