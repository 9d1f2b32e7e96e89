# What `cmake --install BUILD --component program` installs: the program, its profiles and schemas, the demo, the shells'
# completions. All of it is found from the program's own place (scene/base/installation.h).

# Owner and name of the public repository, as in OWNER/NAME: where releases and the GitHub action come from.
set(CAMPUSWALK_REPOSITORY "" CACHE STRING "Public repository on GitHub, OWNER/NAME")
# What `campuswalk init` pins the action to.
set(CAMPUSWALK_COMMIT "" CACHE STRING "Commit of that repository with this version, 40 digits")
if(CAMPUSWALK_REPOSITORY AND NOT CAMPUSWALK_REPOSITORY MATCHES "^[A-Za-z0-9-]+/[A-Za-z0-9._-]+$")
    message(FATAL_ERROR "CAMPUSWALK_REPOSITORY is '${CAMPUSWALK_REPOSITORY}', not OWNER/NAME")
endif()
if(CAMPUSWALK_COMMIT AND NOT CAMPUSWALK_COMMIT MATCHES "^[0-9a-f]+$")
    message(FATAL_ERROR "CAMPUSWALK_COMMIT is '${CAMPUSWALK_COMMIT}', not a commit: a tag can be moved")
endif()

include(GNUInstallDirs)

function(campuswalk_install_program)
    set(data ${CMAKE_INSTALL_DATADIR}/campuswalk)
    install(TARGETS campuswalk RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
    # As in the repository, since the demo's files name each other.
    foreach(folder avatars lights schema)
        install(DIRECTORY ${PROJECT_SOURCE_DIR}/config/${folder} DESTINATION ${data}/config COMPONENT program)
    endforeach()
    install(
        DIRECTORY ${PROJECT_SOURCE_DIR}/config/walks
        DESTINATION ${data}/config
        COMPONENT program
        PATTERN expectations EXCLUDE)
    install(FILES ${PROJECT_SOURCE_DIR}/config/demo.campus.yaml DESTINATION ${data}/config COMPONENT program)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/campus_assets/demo DESTINATION ${data}/campus_assets COMPONENT program)

    set(completions "bash:bash-completion/completions/campuswalk" "zsh:zsh/vendor-completions/_campuswalk"
                    "fish:fish/vendor_completions.d/campuswalk.fish")
    foreach(completion IN LISTS completions)
        string(REGEX REPLACE ":.*" "" shell ${completion})
        string(REGEX REPLACE ".*:" "" file ${completion})
        set(written ${PROJECT_BINARY_DIR}/completions/${shell})
        cmake_path(GET file PARENT_PATH folder)
        cmake_path(GET file FILENAME name)
        install(
            CODE "file(MAKE_DIRECTORY \"${PROJECT_BINARY_DIR}/completions\")
                  execute_process(COMMAND \"$<TARGET_FILE:campuswalk>\" completion ${shell}
                                  OUTPUT_FILE \"${written}\" COMMAND_ERROR_IS_FATAL ANY)"
            COMPONENT program)
        install(
            FILES ${written}
            DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder}
            RENAME ${name}
            COMPONENT program)
    endforeach()
endfunction()
