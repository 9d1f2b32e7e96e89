# Builds tools/viewer with node and npm into the build tree, and from it CAMPUSWALK_VIEWER_SOURCE, which holds it.
# CAMPUSWALK_VIEWER_BUNDLE names a folder with a viewer.js and viewer.css that were built elsewhere, for machines
# without npm or a registry.

set(CAMPUSWALK_VIEWER_BUNDLE "" CACHE PATH "Folder with a viewer.js and viewer.css to use instead of building them")
set(viewer ${PROJECT_SOURCE_DIR}/tools/viewer)
set(built ${PROJECT_BINARY_DIR}/viewer)
set(CAMPUSWALK_VIEWER_SOURCE ${built}/viewer_bundle.cpp)
file(MAKE_DIRECTORY ${built}) # make changes into a working directory before the first command could make it

if(CAMPUSWALK_VIEWER_BUNDLE)
    set(bundle ${CAMPUSWALK_VIEWER_BUNDLE})
else()
    set(bundle ${built}/bundle)
    find_program(CAMPUSWALK_NODE node)
    find_program(CAMPUSWALK_NPM npm)
    if(NOT CAMPUSWALK_NODE OR NOT CAMPUSWALK_NPM)
        message(FATAL_ERROR "HTML reports need node and npm: run tools/setup-report, or configure with "
                            "-DCAMPUSWALK_HTML=OFF to do without, or with -DCAMPUSWALK_VIEWER_BUNDLE=FOLDER")
    endif()
    # Packages are installed beside a copy of their list: nothing is written into the sources.
    add_custom_command(
        OUTPUT ${built}/package-lock.json
        COMMAND ${CMAKE_COMMAND} -E copy ${viewer}/package.json ${viewer}/package-lock.json ${built}
        COMMAND ${CAMPUSWALK_NPM} ci --ignore-scripts --omit=dev --no-audit --no-fund --loglevel=error
        WORKING_DIRECTORY ${built}
        DEPENDS ${viewer}/package.json ${viewer}/package-lock.json
        COMMENT "Installing the viewer's packages"
        VERBATIM)
    file(GLOB_RECURSE viewer_sources CONFIGURE_DEPENDS ${viewer}/src/*)
    add_custom_command(
        OUTPUT ${bundle}/viewer.js ${bundle}/viewer.css
        COMMAND ${CMAKE_COMMAND} -E rm -rf ${built}/src
        COMMAND ${CMAKE_COMMAND} -E copy_directory ${viewer}/src ${built}/src
        COMMAND ${CMAKE_COMMAND} -E copy ${viewer}/build.mjs ${viewer}/tsconfig.json ${built}
        COMMAND ${CAMPUSWALK_NODE} ${built}/build.mjs --outdir ${bundle}
        DEPENDS ${built}/package-lock.json ${viewer}/build.mjs ${viewer}/tsconfig.json ${viewer_sources}
        COMMENT "Bundling the viewer"
        VERBATIM)
endif()

add_custom_command(
    OUTPUT ${CAMPUSWALK_VIEWER_SOURCE}
    COMMAND ${CMAKE_COMMAND} -DSCRIPT=${bundle}/viewer.js -DSTYLE=${bundle}/viewer.css
            -DOUTPUT=${CAMPUSWALK_VIEWER_SOURCE} -P ${PROJECT_SOURCE_DIR}/tools/cmake/EmbedViewer.cmake
    DEPENDS ${bundle}/viewer.js ${bundle}/viewer.css ${PROJECT_SOURCE_DIR}/tools/cmake/EmbedViewer.cmake
    COMMENT "Embedding the viewer"
    VERBATIM)
# It is one string, longer than compilers must accept.
set_source_files_properties(${CAMPUSWALK_VIEWER_SOURCE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
                                                                   COMPILE_OPTIONS -Wno-overlength-strings)
