# What `cmake --install BUILD --component collision` puts where find_package(campuswalk CONFIG) finds it.

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# campuswalk_package(LAYER)
# Installs the layer's library, its public headers (the file set HEADERS) under their names from the
# repository's root, and the package's files.
function(campuswalk_package layer)
    set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/campuswalk)
    set_target_properties(campuswalk_${layer} PROPERTIES EXPORT_NAME ${layer})
    target_compile_features(campuswalk_${layer} PUBLIC cxx_std_20)
    install(
        TARGETS campuswalk_${layer}
        EXPORT campuswalk
        COMPONENT ${layer}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/campuswalk)
    install(
        EXPORT campuswalk
        FILE campuswalkTargets.cmake
        NAMESPACE campuswalk::
        DESTINATION ${folder}
        COMPONENT ${layer})

    set(written ${PROJECT_BINARY_DIR}/package)
    configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/campuswalkConfig.cmake.in
                                  ${written}/campuswalkConfig.cmake INSTALL_DESTINATION ${folder})
    # Before 1.0 a new minor version may break what used the one before.
    write_basic_package_version_file(${written}/campuswalkConfigVersion.cmake COMPATIBILITY SameMinorVersion)
    install(
        FILES ${written}/campuswalkConfig.cmake ${written}/campuswalkConfigVersion.cmake
        DESTINATION ${folder}
        COMPONENT ${layer})
endfunction()

# campuswalk_engine_package(ENTRY_HEADERS headers…)
# What `--component engine` adds to it: the layers that run walks, and the headers `ENTRY_HEADERS` with all they include.
function(campuswalk_engine_package)
    cmake_parse_arguments(arg "" "" "ENTRY_HEADERS" ${ARGN})
    set(targets "")
    foreach(layer model import scene broadphase engine loader)
        set_target_properties(campuswalk_${layer} PROPERTIES EXPORT_NAME ${layer})
        target_compile_features(campuswalk_${layer} PUBLIC cxx_std_20)
        target_include_directories(campuswalk_${layer}
                                   PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/campuswalk>)
        list(APPEND targets campuswalk_${layer})
    endforeach()
    install(
        TARGETS ${targets}
        EXPORT campuswalkEngine
        COMPONENT engine
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(
        EXPORT campuswalkEngine
        FILE campuswalkEngineTargets.cmake
        NAMESPACE campuswalk::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/campuswalk
        COMPONENT engine)
    install(
        CODE "set(root \"${PROJECT_SOURCE_DIR}\")
              set(entry_headers \"${arg_ENTRY_HEADERS}\")
              set(destination \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/campuswalk\")
              include(\"${PROJECT_SOURCE_DIR}/tools/cmake/InstallHeaders.cmake\")"
        COMPONENT engine)
endfunction()
