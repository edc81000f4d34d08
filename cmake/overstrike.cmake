# How this house builds: one helper for libraries, one for tests.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
# No fused multiply-add behind our back: the same bytes from every compiler and at every level.
# Nobody puts functions of ours in the place of others: calls within a file may be inlined although
# code is position-independent.
add_compile_options(-fno-semantic-interposition)
add_compile_options(-ffp-contract=off -Wall -Wextra -Wshadow -Wnon-virtual-dtor)
if(OVERSTRIKE_WERROR)
  add_compile_options(-Werror)
endif()
if(OVERSTRIKE_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
find_program(OVERSTRIKE_CCACHE ccache)
if(OVERSTRIKE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${OVERSTRIKE_CCACHE})
endif()
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

# overstrike_library(core SOURCES a.cpp ... LINKS public targets ... PRIVATE private targets ...)
# makes overstrike_core with the alias overstrike::core; includes are by path from the root.
function(overstrike_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE" ${ARGN})
  add_library(overstrike_${name} STATIC ${arg_SOURCES})
  add_library(overstrike::${name} ALIAS overstrike_${name})
  set_target_properties(overstrike_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(overstrike_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/overstrike>)
  target_link_libraries(overstrike_${name} PUBLIC ${arg_LINKS} PRIVATE ${arg_PRIVATE})
endfunction()

# overstrike_test(name SOURCES a_test.cpp ... LINKS targets ... [LABELS long]) makes one ctest entry a file.
function(overstrike_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;LABELS" ${ARGN})
  if(NOT OVERSTRIKE_TESTS)
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINKS} GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE OVERSTRIKE_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             OVERSTRIKE_BINARY_DIR="${PROJECT_BINARY_DIR}")
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES TIMEOUT 600)
  if(arg_LABELS)
    set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}")
  endif()
endfunction()
