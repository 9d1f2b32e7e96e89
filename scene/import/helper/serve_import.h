#pragma once

namespace campuswalk::scene {

/// The first argument of a program that is started as import helper.
inline constexpr const char* kImportHelperArgument = "import-helper";

/// The main function of the helper: reads the request from standard input, limits its resources, imports, and
/// writes the response to standard output; both are files. Returns only without a response, with the exit
/// code.
int serve_import();

}  // namespace campuswalk::scene
