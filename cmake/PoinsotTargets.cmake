# poinsot_compile_options(TARGET): the warnings every target of the project is held to.
function(poinsot_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # g++ 12 sees overlapping copies in std::string operator+ where there are none (GCC bug 105329).
    target_compile_options(${target} PRIVATE -Wno-restrict)
  endif()
  if(POINSOT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()

# poinsot_library(NAME ROOMS room...): one static library from the sources of the rooms, exported as poinsot::NAME.
function(poinsot_library name)
  cmake_parse_arguments(arg "" "" "ROOMS" ${ARGN})
  set(sources)
  foreach(room ${arg_ROOMS})
    file(GLOB room_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/src/${room}/*.cpp")
    list(APPEND sources ${room_sources})
  endforeach()
  add_library(poinsot_${name} STATIC ${sources})
  add_library(poinsot::${name} ALIAS poinsot_${name})
  set_target_properties(poinsot_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_compile_features(poinsot_${name} PUBLIC cxx_std_20)
  target_include_directories(poinsot_${name} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>"
                                                    "$<INSTALL_INTERFACE:include>"
                                             PRIVATE "${PROJECT_SOURCE_DIR}/src")
  target_compile_definitions(poinsot_${name} PRIVATE POINSOT_VERSION="${PROJECT_VERSION}")
  poinsot_compile_options(poinsot_${name})
endfunction()

# poinsot_test(ROOM): one test program from tests/ROOM/*_test.cpp, each test case known to ctest.
function(poinsot_test room)
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${room}/*_test.cpp")
  if(NOT sources)
    return()
  endif()
  add_executable(test_${room} ${sources})
  target_link_libraries(test_${room} PRIVATE poinsot::problem GTest::gtest_main rapidcheck rapidcheck_gtest Eigen3::Eigen fmt::fmt
                                             nlohmann_json::nlohmann_json)
  target_include_directories(test_${room} PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}/src")
  target_compile_definitions(test_${room} PRIVATE POINSOT_VERSION="${PROJECT_VERSION}"
                                                  POINSOT_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  poinsot_compile_options(test_${room})
  # Tests run short and compile long. With little optimisation g++ 12 takes Eigen's storage for uninitialised.
  target_compile_options(
    test_${room} PRIVATE "$<$<CONFIG:Release>:-O1>"
                         "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>")
  gtest_discover_tests(test_${room} PROPERTIES TIMEOUT 900 DISCOVERY_TIMEOUT 60)
endfunction()
