# cmake -DSCRIPT=viewer.js -DSTYLE=viewer.css -DOUTPUT=FILE.cpp -P EmbedViewer.cmake
# Writes the viewer's files as a source file.
cmake_policy(VERSION 3.25)
file(READ ${SCRIPT} script)
file(READ ${STYLE} style)
foreach(text IN ITEMS script style)
    string(FIND "${${text}}" ")campuswalk\"" at)
    if(NOT at EQUAL -1)
        message(FATAL_ERROR "The viewer's ${text} would end a string literal")
    endif()
endforeach()
file(WRITE ${OUTPUT} "// Written by tools/cmake/EmbedViewer.cmake.
#include \"tools/campuswalk/run/html/viewer_bundle.h\"

namespace campuswalk::tools {

const engine::ViewerBundle& viewer_bundle() {
    static const engine::ViewerBundle bundle = {R\"campuswalk(${script})campuswalk\",
                                                    R\"campuswalk(${style})campuswalk\"};
    return bundle;
}

}  // namespace campuswalk::tools
")
