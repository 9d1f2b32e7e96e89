// Read by LeakSanitizer at the end of a test program, unused in other builds. Mesa 22.3 leaks 480 bytes per
// context, pango 1.50 the fontconfig settings of every font map, 27 kB each.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): LeakSanitizer's name for it
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\nleak:libEGL\nleak:libfontconfig\n";
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
