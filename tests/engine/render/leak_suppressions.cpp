// Read by LeakSanitizer at the end of a test program, unused in other builds. Mesa keeps 480 bytes a context,
// fontconfig and pango their tables of types and families, for as long as the process lives.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa\nleak:libfontconfig\nleak:libpango\nleak:libgobject\nleak:libglib\n";
}
