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
