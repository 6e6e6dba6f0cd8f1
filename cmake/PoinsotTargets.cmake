# poinsot_compile_options(TARGET): the warnings every target of the project is held to.
function(poinsot_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Where files are compiled together, a name of one file is neither shadowed by a local one of another nor seen in a header.
    target_compile_options(${target} PRIVATE -Wshadow=local -Wno-subobject-linkage)
    # g++ 12 sees overlapping copies in std::string operator+ where there are none (GCC bug 105329).
    target_compile_options(${target} PRIVATE -Wno-restrict)
    # From 128 MB on it would look again and again for memory that it no longer needs: seven parts in a hundred of its
    # time, for a fifth of the memory, of which the largest source then takes 2 GB.
    target_compile_options(${target} PRIVATE "$<$<CONFIG:Release,RelWithDebInfo>:--param=ggc-min-heapsize=1000000>")
  endif()
  if(POINSOT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# poinsot_compile_briefly(TARGET): what runs short and compiles long. With the sanitizers g++ leaves out what moves and
# splits variables, which is a quarter to a half of its time there.
function(poinsot_compile_briefly target)
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:-O1>")
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Og)
  endif()
endfunction()

# poinsot_sources(VARIABLE FOLDER PATTERN): the sources below a folder. Those of one room are compiled together, a few at
# a time: reading the headers of Eigen and of the standard library takes longer than compiling what uses them.
function(poinsot_sources variable folder pattern)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${folder}/${pattern}")
  set(${variable} ${sources} PARENT_SCOPE)
  set(counts)
  foreach(source ${sources})
    cmake_path(GET source PARENT_PATH room)
    cmake_path(RELATIVE_PATH room BASE_DIRECTORY "${PROJECT_SOURCE_DIR}/src")
    string(MAKE_C_IDENTIFIER "${room}" room)
    if(NOT DEFINED count_${room})
      set(count_${room} 0)
    endif()
    math(EXPR batch "${count_${room}} / ${POINSOT_SOURCES_TOGETHER}")
    math(EXPR count_${room} "${count_${room}} + 1")
    set_source_files_properties("${source}" DIRECTORY "${PROJECT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}"
                                PROPERTIES UNITY_GROUP "${room}_${batch}")
  endforeach()
endfunction()

# poinsot_compile_together(TARGET): how each target of the sources of rooms is compiled.
function(poinsot_compile_together target)
  # The libraries go into shared objects too, such as a Python module. Hidden names cost nothing there: without them every
  # call that another object could take over would be neither inlined nor direct.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
                                             VISIBILITY_INLINES_HIDDEN ON)
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX UNITY_BUILD ${POINSOT_UNITY} UNITY_BUILD_MODE GROUP
                                             UNITY_BUILD_CODE_BEFORE_INCLUDE
                                             "// NOLINTNEXTLINE(bugprone-suspicious-include)")
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
                                              "$<INSTALL_INTERFACE:include>"
                                       PRIVATE "${PROJECT_SOURCE_DIR}/src")
  poinsot_compile_options(${target})
endfunction()

# poinsot_library(NAME FLOORS floor... [LESS_OPTIMISED room...]): one static library from the sources of the floors,
# exported as poinsot::NAME. Rooms that compile long and run short are less optimised.
function(poinsot_library name)
  cmake_parse_arguments(arg "" "" "FLOORS;LESS_OPTIMISED" ${ARGN})
  set(sources)
  foreach(floor ${arg_FLOORS})
    poinsot_sources(floor_sources "${PROJECT_SOURCE_DIR}/src/${floor}" "*.cpp")
    list(APPEND sources ${floor_sources})
  endforeach()
  if(arg_LESS_OPTIMISED)
    set(less ${sources})
    list(JOIN arg_LESS_OPTIMISED "|" rooms)
    list(FILTER less INCLUDE REGEX "/(${rooms})/[^/]*$")
    list(REMOVE_ITEM sources ${less})
    add_library(poinsot_${name}_less_optimised OBJECT ${less})
    poinsot_compile_together(poinsot_${name}_less_optimised)
    poinsot_compile_briefly(poinsot_${name}_less_optimised)
    list(APPEND sources "$<TARGET_OBJECTS:poinsot_${name}_less_optimised>")
  endif()
  add_library(poinsot_${name} STATIC ${sources})
  add_library(poinsot::${name} ALIAS poinsot_${name})
  set_target_properties(poinsot_${name} PROPERTIES EXPORT_NAME ${name})
  poinsot_compile_together(poinsot_${name})
endfunction()

# poinsot_test(ROOM FOLDER): one test program from FOLDER/**/*_test.cpp below tests/, each test case known to ctest.
function(poinsot_test room folder)
  poinsot_sources(sources "${CMAKE_CURRENT_SOURCE_DIR}/${folder}" "*_test.cpp")
  add_executable(test_${room} ${sources})
  set_target_properties(test_${room} PROPERTIES UNITY_BUILD ${POINSOT_UNITY} UNITY_BUILD_MODE GROUP)
  target_link_libraries(test_${room} PRIVATE poinsot::problem GTest::gtest_main Eigen3::Eigen fmt::fmt
                                             nlohmann_json::nlohmann_json)
  target_include_directories(test_${room} PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}/src")
  target_compile_definitions(test_${room} PRIVATE POINSOT_VERSION="${PROJECT_VERSION}"
                                                  POINSOT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  poinsot_compile_options(test_${room})
  poinsot_compile_briefly(test_${room})
  # With little optimisation g++ 12 takes Eigen's storage for uninitialised.
  target_compile_options(
    test_${room} PRIVATE "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>"
                         # Headers read beforehand are not known to be the system's: it tells of their strings.
                         "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overread;-Wno-stringop-overflow>")
  # Read once for all test programs, which is half of what compiling a test takes.
  if(TARGET test_math AND NOT room STREQUAL math)
    target_precompile_headers(test_${room} REUSE_FROM test_math)
  else()
    target_precompile_headers(test_${room} PRIVATE <gtest/gtest.h> <fmt/format.h> <Eigen/Dense> <algorithm> <array> <cmath>
                              <filesystem> <fstream> <functional> <map> <memory> <optional> <random> <set> <sstream> <string>
                              <vector>)
  endif()
  gtest_discover_tests(test_${room} PROPERTIES TIMEOUT 900 DISCOVERY_TIMEOUT 60)
endfunction()
