# How every folder of the project is built: one place for flags, layers and tests.

# A compiler cache, where there is one. The sloppiness is what precompiled headers need: ccache then
# hashes the header's text in place of its time stamp. It looks by the sources alone and not by what
# the preprocessor makes of them, so that a first build does not preprocess every file twice.
find_program(CCACHE ccache)
if(CCACHE AND PROJECT_IS_TOP_LEVEL)
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE})
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1 ${CCACHE})
endif()

# Third parties. Which folder may use which is in scripts/check_layers.
if(NOT RASTERPROOF_WEB)
  find_package(Threads REQUIRED)
endif()
if(NOT RASTERPROOF_FUZZING_ENGINE AND NOT RASTERPROOF_LIBRARY_ONLY AND NOT RASTERPROOF_WEB)
  find_package(fmt REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(PNG REQUIRED)
  find_package(assimp REQUIRED)
  find_package(pugixml REQUIRED)
endif()
if(RASTERPROOF_TESTS)
  find_package(GTest REQUIRED)
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
# What sanitizers insert takes longer to be optimised than it saves the tests.
if(RASTERPROOF_LUMPS AND RASTERPROOF_SANITIZE)
  set(CMAKE_CXX_FLAGS_RELEASE "-O1 -DNDEBUG")
endif()
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")

# The code generator of every target. Contraction would change signs; debug information costs build
# time.
add_library(rasterproof_flags INTERFACE)
target_compile_options(rasterproof_flags INTERFACE
  -Wall -Wextra -Wconversion -ffp-contract=off
  # The compiler of an engine of others may be any.
  $<$<BOOL:${RASTERPROOF_FUZZING_ENGINE}>:-Wno-error -Wno-unused-command-line-argument>
  $<$<AND:$<BOOL:${PROJECT_IS_TOP_LEVEL}>,$<NOT:$<BOOL:${RASTERPROOF_FUZZING_ENGINE}>>>:-Werror>
  # g++ 12 at -O2: two neighbouring doubles rounded to float and widened again, vectorised as a
  # pair, lose the rounding. Found by exact/environment.cc, which refuses a build without this.
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_include_directories(rasterproof_flags INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
if(RASTERPROOF_SANITIZE)
  target_compile_options(rasterproof_flags INTERFACE
    -fsanitize=${RASTERPROOF_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1
    # Null pointers and objects too small are AddressSanitizer's as well; twice cost a fifth more.
    -fno-sanitize=null,object-size)
  target_link_options(rasterproof_flags INTERFACE -fsanitize=${RASTERPROOF_SANITIZE})
  # The usual linker takes several times as long for programs of 50 MB.
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=lld RASTERPROOF_LLD)
  if(RASTERPROOF_LLD)
    target_link_options(rasterproof_flags INTERFACE -fuse-ld=lld)
  endif()
  # Stacks of functions that have returned are watched always: with a switch at run time, as by
  # default, every function is compiled twice, which takes a tenth longer.
  if(RASTERPROOF_SANITIZE MATCHES "address" AND CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    target_compile_options(rasterproof_flags INTERFACE -fsanitize-address-use-after-return=always)
  endif()
  # The other builds check the format strings of fmt.
  target_compile_definitions(rasterproof_flags INTERFACE FMT_CONSTEVAL=)
endif()
# libFuzzer is told which branches an input took in what is put to the test, in the oracle and in
# the recipes; not what was compared, which costs a third of the time, and what decides here are
# signs of floating-point numbers, which it does not see. (Parsers ask for it.) What judges is not
# seen: libFuzzer goes over every branch it sees after each execution. Stacks of functions that have
# returned are the tests' to watch (preset asan-ubsan).
if(RASTERPROOF_FUZZ)
  target_compile_options(rasterproof_flags INTERFACE
    -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp)
  if(RASTERPROOF_SANITIZE)
    target_compile_options(rasterproof_flags INTERFACE -fsanitize-address-use-after-return=never)
  endif()
endif()
if(RASTERPROOF_FUZZ OR RASTERPROOF_FUZZING_ENGINE)
  set(unseen -fno-sanitize-coverage=inline-8bit-counters,pc-table,indirect-calls,stack-depth)
else()
  set(unseen)
endif()
if(RASTERPROOF_FUZZING_ENGINE)
  target_compile_options(rasterproof_flags INTERFACE -fno-sanitize-coverage=trace-cmp)
  # Boost before 1.81 asks for std::unary_function, which libc++ no longer has.
  target_compile_definitions(rasterproof_flags INTERFACE BOOST_NO_CXX98_FUNCTION_BASE)
endif()

# Reading headers is more than half of what a file costs. RASTERPROOF_LUMPS compiles the files of a
# target several at a time, as one that includes them, so that they read their headers once. So a
# local name is unique in its target; a file that can't keep to that, or that has options or
# definitions of its own, is compiled alone.

# rasterproof_lump(TARGET SIZE)
function(rasterproof_lump target size)
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${RASTERPROOF_LUMPS}
    UNITY_BUILD_BATCH_SIZE ${size}) # headers cost little then, and no core waits long for the last
endfunction()

# rasterproof_alone(SOURCE ...)
function(rasterproof_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# The code of libraries may become a part of a shared one (kit/oracle), whose functions nobody may
# replace: calls among them stay direct.
set(for_shared -fno-semantic-interposition)

# Headers of the standard library are precompiled where files are compiled in lumps, and with
# GoogleTest's for tests everywhere. Where a file is compiled alone it must include what it uses.
set(standard_headers <algorithm> <array> <cmath> <cstddef> <cstdint> <functional> <limits> <memory>
  <optional> <span> <string> <string_view> <vector>)
file(WRITE ${PROJECT_BINARY_DIR}/precompiled.cc "")
# What takes long in most tests is the libraries' code, and in compiling them to optimise them, and
# what sanitizers insert. Some compute themselves. What reads options and writes text takes longer
# to be optimised than to run.
set(test_optimisation)
set(computing_optimisation)
set(text_optimisation)
if(RASTERPROOF_LUMPS)
  set(test_optimisation -O0)
  if(RASTERPROOF_SANITIZE)
    set(computing_optimisation -O0)
    set(text_optimisation -O0)
  else()
    set(computing_optimisation -O1)
    set(text_optimisation -O1)
  endif()
endif()
# A precompiled header is for the options of one target and of those that are compiled like it.
function(rasterproof_precompile name)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cc)
  target_link_libraries(${name} PRIVATE rasterproof_flags)
  target_compile_options(${name} PRIVATE ${for_shared} ${ARGN})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(${name} PRIVATE ${standard_headers})
endfunction()
if(RASTERPROOF_SANITIZE OR RASTERPROOF_LUMPS)
  rasterproof_precompile(rasterproof_precompiled)
endif()
if(RASTERPROOF_LUMPS)
  rasterproof_precompile(rasterproof_precompiled_text ${text_optimisation})
endif()
function(rasterproof_precompile_tests name)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/precompiled.cc)
  target_link_libraries(${name} PRIVATE rasterproof_flags GTest::gtest)
  target_compile_options(${name} PRIVATE ${ARGN})
  target_precompile_headers(${name} PRIVATE ${standard_headers} <gtest/gtest.h>)
endfunction()
if(RASTERPROOF_TESTS)
  rasterproof_precompile_tests(rasterproof_precompiled_test ${test_optimisation})
  if(NOT "${computing_optimisation}" STREQUAL "${test_optimisation}")
    rasterproof_precompile_tests(rasterproof_precompiled_computing_test ${computing_optimisation})
  endif()
endif()

# rasterproof_headers(TARGET SCOPE): where the headers of a target lie, for who links it.
# "kit/main.h" and <rasterproof/kit/main.h> both find one, in a build tree and installed.
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/include)
file(CREATE_LINK ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/include/rasterproof SYMBOLIC)
function(rasterproof_headers target scope)
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:include> $<INSTALL_INTERFACE:include/rasterproof>)
endfunction()

# Of loops over samples, vectorised as users of rasterizers build theirs. Sanitized, the third level
# only takes longer to compile.
set(kernel_level "$<$<CONFIG:Release>:-O3>")
if(RASTERPROOF_SANITIZE)
  set(kernel_level)
endif()

# rasterproof_library(NAME SOURCES a.cc ... [LINK target ...] [PRIVATE_LINK target ...] [LUMP n]
#   [TEXT])
# makes the static library rasterproof_NAME. LINK is for what its headers include, PRIVATE_LINK for
# what only its sources do; both name whole targets (rasterproof_core, fmt::fmt). LUMP: files at a
# time, 20 where it is left out. TEXT: it reads options and writes text, which takes longer to be
# optimised than to be compiled, so that in lumps it is optimised less.
function(rasterproof_library name)
  cmake_parse_arguments(ARG "TEXT" "LUMP" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  if(NOT ARG_LUMP)
    set(ARG_LUMP 20)
  endif()
  add_library(rasterproof_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(rasterproof_${name}
    PUBLIC ${ARG_LINK} PRIVATE rasterproof_flags ${ARG_PRIVATE_LINK})
  target_compile_options(rasterproof_${name} PRIVATE ${for_shared})
  set_target_properties(rasterproof_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  rasterproof_headers(rasterproof_${name} PUBLIC)
  rasterproof_lump(rasterproof_${name} ${ARG_LUMP})
  if(ARG_TEXT AND RASTERPROOF_LUMPS)
    target_compile_options(rasterproof_${name} PRIVATE ${text_optimisation})
    target_precompile_headers(rasterproof_${name} REUSE_FROM rasterproof_precompiled_text)
  elseif(RASTERPROOF_SANITIZE OR RASTERPROOF_LUMPS)
    target_precompile_headers(rasterproof_${name} REUSE_FROM rasterproof_precompiled)
  endif()
endfunction()

# What registers itself is a row in a file of its own folder, as "extern constinit const Property
# kItsName{", which nobody else names: the build makes the list of the rows.

# rows_of(OUT Type source ...): the names of the rows of these files, sorted.
function(rows_of out type)
  set(all)
  foreach(source ${ARGN})
    file(STRINGS ${source} rows REGEX "^extern constinit const ${type} k")
    if(NOT rows)
      message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/${source} has no row: begin one with "
        "'extern constinit const ${type} kItsName{'")
    endif()
    list(TRANSFORM rows REPLACE "^.* (k[A-Za-z0-9]+).*$" "\\1")
    list(APPEND all ${rows})
  endforeach()
  list(SORT all)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  set(${out} ${all} PARENT_SCOPE)
endfunction()

# write_rows(FILE.cc Type header name row ...): kAllNAME and kNumberOfNAME, of these rows, in the
# namespace of the header's folder, and of the type within it (space::Type).
function(write_rows file type header name)
  string(REGEX REPLACE "/.*" "" space ${header})
  if(type MATCHES "^(.+)::(.+)$")
    string(APPEND space "::${CMAKE_MATCH_1}")
    set(type ${CMAKE_MATCH_2})
  endif()
  list(JOIN ARGN ", " declared)
  list(JOIN ARGN ",\n    &" listed)
  file(CONFIGURE OUTPUT ${file} CONTENT [[#include <cstddef>
#include <iterator>

#include "@header@"

namespace rasterproof::@space@ {

extern const @type@ @declared@;

extern const @type@* const kAll@name@[];
extern const std::size_t kNumberOf@name@;
const @type@* const kAll@name@[] = {
    &@listed@};
const std::size_t kNumberOf@name@ = std::size(kAll@name@);

}  // namespace rasterproof::@space@
]] @ONLY)
endfunction()

# rasterproof_optimised(OUT TARGET ...): the libraries that the targets link, optimised in full. Not
# the exact one and its rivals: of their files some are for newer processors alone.
function(rasterproof_optimised out)
  set(found "")
  set(next ${ARGN})
  while(NOT "${next}" STREQUAL "")
    list(POP_FRONT next target)
    if(NOT target MATCHES "^rasterproof_" OR target IN_LIST seen)
      continue()
    endif()
    list(APPEND seen ${target})
    get_target_property(links ${target} INTERFACE_LINK_LIBRARIES)
    string(REGEX REPLACE "\\$<LINK_ONLY:([^>]*)>" "\\1" links "${links}")
    list(APPEND next ${links})
    get_target_property(type ${target} TYPE)
    get_target_property(options ${target} COMPILE_OPTIONS)
    if(type STREQUAL STATIC_LIBRARY AND NOT options MATCHES "-O[01]" AND
        NOT target MATCHES "^rasterproof_(rasterize|rivals)$")
      list(APPEND found ${target})
    endif()
  endwhile()
  set(${out} ${found} PARENT_SCOPE)
endfunction()

# rasterproof_unsanitized(TARGET ...): what only tests labelled `unsanitized` run. A build with
# sanitizers makes it when it is asked for.
function(rasterproof_unsanitized)
  if(RASTERPROOF_SANITIZE)
    set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
endfunction()

# rasterproof_large_pages(PROGRAM): its large blocks of memory come in large pages. Sanitizers have
# an allocator of their own.
add_library(rasterproof_memory OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tool/large_pages.cc)
target_link_libraries(rasterproof_memory PRIVATE rasterproof_flags)
set_target_properties(rasterproof_memory PROPERTIES POSITION_INDEPENDENT_CODE ON)
function(rasterproof_large_pages program)
  if(NOT RASTERPROOF_SANITIZE)
    target_sources(${program} PRIVATE $<TARGET_OBJECTS:rasterproof_memory>)
  endif()
endfunction()

# A test that takes so long hangs: no limit of a test is one that a loaded machine reaches.
set(hang_seconds 3600)

# rasterproof_test(NAME SOURCES a_test.cc ... LINK target ... [LABELS label ...] [SHARDS n]
#   [COMPUTES])
# makes one GoogleTest program per folder; ctest runs all its test cases as one ctest test "NAME",
# or as n of them, "NAME_1" and so on, that share them out. Where sanitizers slow it down it runs a
# share of its cases: see tests/share.h. COMPUTES: its own loops are worth optimising.
function(rasterproof_test name)
  cmake_parse_arguments(ARG "COMPUTES" "SHARDS" "SOURCES;LINK;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name}
    PRIVATE rasterproof_flags ${ARG_LINK} GTest::gtest GTest::gtest_main)
  rasterproof_large_pages(${name})
  rasterproof_lump(${name} 10)
  if(ARG_COMPUTES AND TARGET rasterproof_precompiled_computing_test)
    target_precompile_headers(${name} REUSE_FROM rasterproof_precompiled_computing_test)
    target_compile_options(${name} PRIVATE ${computing_optimisation})
  else()
    target_precompile_headers(${name} REUSE_FROM rasterproof_precompiled_test)
    target_compile_options(${name} PRIVATE ${test_optimisation})
  endif()
  # Of the copies of an inline function the linker keeps the first that it reads. Let that be a
  # library's, or the libraries' loops run what is not optimised: that took 2.5 times as long.
  if(RASTERPROOF_LUMPS)
    rasterproof_optimised(libraries ${ARG_LINK})
    list(TRANSFORM libraries REPLACE ".+" "$<TARGET_FILE:\\0>")
    target_link_options(${name} PRIVATE
      -Wl,--whole-archive ${libraries} -Wl,--no-whole-archive)
  endif()
  set(tests ${name})
  if(ARG_SHARDS)
    set(tests "")
    foreach(shard RANGE 1 ${ARG_SHARDS})
      list(APPEND tests ${name}_${shard})
    endforeach()
  endif()
  set(shard 0)
  foreach(test ${tests})
    add_test(NAME ${test} COMMAND ${name} --gtest_brief=1 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${test} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT ${hang_seconds})
    if(ARG_SHARDS)
      set_tests_properties(${test} PROPERTIES
        ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${shard}"
        # `./run test` names the folder of the results; each shard has a file there.
        ENVIRONMENT_MODIFICATION "GTEST_OUTPUT=string_append:${test}.xml")
      math(EXPR shard "${shard} + 1")
    endif()
    # Those that take longest begin first, or one core waits for the other at the end.
    if(name STREQUAL mutants_test)
      set_tests_properties(${test} PROPERTIES COST 100)
    elseif(name MATCHES "^(props|bench)_test$")
      set_tests_properties(${test} PROPERTIES COST 50)
    endif()
  endforeach()
endfunction()
