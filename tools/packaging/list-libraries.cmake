# cmake -DPROGRAM=FILE -DLIBRARY=FILE -DOUTPUT=FILE -P list-libraries.cmake
# Writes the paths of all shared libraries that a program and a library it opens need, but those of glibc.
cmake_policy(VERSION 3.25)
file(GET_RUNTIME_DEPENDENCIES
     EXECUTABLES ${PROGRAM}
     LIBRARIES ${LIBRARY}
     RESOLVED_DEPENDENCIES_VAR found
     POST_EXCLUDE_REGEXES "/ld-linux[^/]*$" "/lib(c|m|dl|rt|pthread|resolv|util|anl|nsl)\\.so\\.[0-9]+$")
list(SORT found)
list(JOIN found "\n" lines)
file(WRITE ${OUTPUT} "${lines}\n")
