# Compiler settings that every target of the project shares, in one place.

get_filename_component(campuswalk_root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

add_library(campuswalk_flags INTERFACE)
# Same bits from every compiler and level: no fused multiply-add behind our back.
target_compile_options(campuswalk_flags INTERFACE -ffp-contract=off)
# Same bits from every processor: with its SSE2 packets Eigen adds three components as (x + y) + z, without them as
# x + (y + z). The second of these takes away what the first does to the layout of its types, so that whoever uses
# an installed layer, with Eigen's usual settings, sees the same ones.
target_compile_definitions(campuswalk_flags INTERFACE EIGEN_DONT_VECTORIZE EIGEN_MAX_STATIC_ALIGN_BYTES=16)
# Some of the libraries ask for it; headers precompiled without it are no use to whoever links them.
target_compile_options(campuswalk_flags INTERFACE -pthread)
target_compile_options(
    campuswalk_flags
    INTERFACE -Wall
              -Wextra
              -Wpedantic
              -Wconversion
              -Wsign-conversion
              -Wshadow
              -Wnon-virtual-dtor
              -Woverloaded-virtual
              # GCC 12 warns about std::string's own operator+ (GCC bug 105651), in three ways where it is
              # precompiled.
              $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow>
              # Clang 14 takes every defaulted operator<=> for such a zero.
              $<$<CXX_COMPILER_ID:GNU>:-Wzero-as-null-pointer-constant>
              $<$<BOOL:${CAMPUSWALK_WERROR}>:-Werror>)
target_include_directories(campuswalk_flags INTERFACE ${campuswalk_root})
# g++ collects its garbage whenever what it holds has doubled, from 128 MB on, which batches do in their first second. With this
# start it seldom does: a twelfth of the work.
target_compile_options(campuswalk_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)

# What a bug in reading strangers' files may become is made harder: in release builds, thus also in the packages, and named here
# rather than left to the compilers' defaults, which differ. tests/tools/hardening_test.py reads it in the built program. Indirect
# jumps are marked, but the program as a whole can't say so to the processor: Debian's start files aren't.
set(campuswalk_hardened $<CONFIG:Release>)
# Not in the generator expression, which would take the comma in `address,undefined` for one of its own.
if(CAMPUSWALK_SANITIZE)
    set(campuswalk_hardened 0)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    set(campuswalk_marked_jumps -fcf-protection)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "aarch64|arm64")
    set(campuswalk_marked_jumps -mbranch-protection=standard)
endif()
set(campuswalk_hardening -D_FORTIFY_SOURCE=2 -fstack-protector-strong ${campuswalk_marked_jumps})
set(campuswalk_hardened_links -Wl,-z,relro,-z,now,-z,noexecstack)
if(NOT BUILD_SHARED_LIBS)
    list(APPEND campuswalk_hardening -fPIE)
    list(APPEND campuswalk_hardened_links -pie)
endif()
target_compile_options(campuswalk_flags INTERFACE "$<${campuswalk_hardened}:${campuswalk_hardening}>")
target_link_options(campuswalk_flags INTERFACE "$<${campuswalk_hardened}:${campuswalk_hardened_links}>")

# Containers check their indices.
add_library(campuswalk_checked_containers INTERFACE)
target_compile_definitions(campuswalk_checked_containers INTERFACE $<${campuswalk_hardened}:_GLIBCXX_ASSERTIONS>)
# Where a query takes a microsecond, neither do they, nor are functions guarded: that would be a tenth of it. Such code reads no
# files, only numbers that others have checked.
add_library(campuswalk_unguarded INTERFACE)
target_compile_options(campuswalk_unguarded INTERFACE "$<${campuswalk_hardened}:-fno-stack-protector;-U_FORTIFY_SOURCE>")

if(CAMPUSWALK_SANITIZE)
    target_compile_options(campuswalk_flags INTERFACE -fsanitize=${CAMPUSWALK_SANITIZE}
                                                      -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(campuswalk_flags INTERFACE -fsanitize=${CAMPUSWALK_SANITIZE})
    # GCC 12 to 14 warn about std::regex under sanitizers (GCC bug 105616).
    target_compile_options(campuswalk_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    # Each shared library calls its own inline functions, not those of the tests, which aren't optimised.
    target_link_options(campuswalk_flags INTERFACE -Wl,-Bsymbolic-functions)
endif()

# Half the time to compile a file goes into reading Eigen. `tools/check-all sanitizers` does without, and without batches,
# so that every file goes on to include what it uses.
set(campuswalk_often_included
    <Eigen/Geometry>
    <algorithm>
    <array>
    <filesystem>
    <functional>
    <map>
    <memory>
    <optional>
    <set>
    <span>
    <string>
    <variant>
    <vector>)
# What nearly every file about walks includes: the variants of steps and expectations, and the campus with its trees.
set(campuswalk_walk_headers ${campuswalk_root}/engine/script/walk.h ${campuswalk_root}/scene/campus/campus.h)

# campuswalk_precompile(TARGET KIND headers… [FROM targets…])
# Parses the headers once for all targets of a kind, which are compiled with the same flags; FROM are the
# targets that bring the headers.
find_package(Eigen3 REQUIRED NO_MODULE)
function(campuswalk_precompile target kind)
    cmake_parse_arguments(arg "" "" "FROM" ${ARGN})
    set(precompiled campuswalk_precompiled_${kind})
    if(NOT TARGET ${precompiled})
        add_library(${precompiled} OBJECT ${campuswalk_root}/tools/cmake/nothing.cpp)
        target_link_libraries(${precompiled} PRIVATE campuswalk_flags Eigen3::Eigen ${arg_FROM})
        target_precompile_headers(${precompiled} PRIVATE ${arg_UNPARSED_ARGUMENTS})
        get_target_property(type ${target} TYPE)
        if(type STREQUAL "SHARED_LIBRARY")
            set_target_properties(${precompiled} PROPERTIES POSITION_INDEPENDENT_CODE ON)
        endif()
    endif()
    target_precompile_headers(${target} REUSE_FROM ${precompiled})
endfunction()

# campuswalk_compile_in_batches(TARGET)
# Compiles up to eighteen files of a folder together, which reads the headers they share once: a third of the work. More
# at a time would be less still, but a change to one file compiles its batch anew. The kernels stay apart: Highway includes
# each of them several times. A batch can hide that a file uses what only its neighbours declare: `tools/check-changed`
# compiles what changed file by file, `tools/check-all sanitizers` everything.
option(CAMPUSWALK_BATCHES "Compile related files together" ON)
function(campuswalk_compile_in_batches target)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "kernels/")
    set(folder "")
    foreach(source IN LISTS sources)
        get_filename_component(path ${source} ABSOLUTE)
        cmake_path(GET path PARENT_PATH parent)
        if(NOT parent STREQUAL folder OR files EQUAL 18)
            set(folder ${parent})
            cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE first)
            string(MAKE_C_IDENTIFIER ${first} first)
            set(files 0)
        endif()
        math(EXPR files "${files} + 1")
        set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${first})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${CAMPUSWALK_BATCHES} UNITY_BUILD_MODE GROUP)
endfunction()

# campuswalk_optimise_little(TARGET)
# For code that runs once per command, such as reading options and YAML: optimising it any further costs a release
# build more time than it ever saves.
function(campuswalk_optimise_little target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# campuswalk_layer(NAME [UNGUARDED] [WALKS] SOURCES… [PUBLIC targets…] [PRIVATE targets…])
# One library a layer, known to others as campuswalk::NAME; WALKS: its files are about walks. Where no query of a microsecond is
# answered, -O3 takes a tenth longer to compile than -O2 and gains nothing.
function(campuswalk_layer name)
    cmake_parse_arguments(arg "UNGUARDED;WALKS" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    add_library(campuswalk_${name} ${arg_SOURCES})
    add_library(campuswalk::${name} ALIAS campuswalk_${name})
    # Whoever uses an installed layer chooses flags of their own.
    target_link_libraries(campuswalk_${name} PUBLIC $<BUILD_INTERFACE:campuswalk_flags> ${arg_PUBLIC}
                          PRIVATE ${arg_PRIVATE})
    if(arg_UNGUARDED)
        set(guards unguarded)
    else()
        set(guards checked_containers)
        target_compile_options(campuswalk_${name} PRIVATE $<$<CONFIG:Release>:-O2>)
    endif()
    target_link_libraries(campuswalk_${name} PRIVATE $<BUILD_INTERFACE:campuswalk_${guards}>)
    if(arg_WALKS)
        campuswalk_precompile(campuswalk_${name} walks_${guards} ${campuswalk_often_included} ${campuswalk_walk_headers}
                              FROM campuswalk_${guards})
    else()
        campuswalk_precompile(campuswalk_${name} layer_${guards} ${campuswalk_often_included} FROM campuswalk_${guards})
    endif()
    campuswalk_compile_in_batches(campuswalk_${name})
endfunction()
