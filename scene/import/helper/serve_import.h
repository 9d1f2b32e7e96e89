#pragma once

namespace campuswalk::scene {

/// The first argument by which a program says that it was started as import helper.
inline constexpr const char* kImportHelperArgument = "import-helper";

/// What such a program does, and nothing else: reads the request from standard input, limits itself, imports,
/// writes the answer to standard output, both of them files. The exit code: 0 for an answer, else none was
/// possible.
int serve_import();

}  // namespace campuswalk::scene
