# poinsot_load_flint_on_demand(TARGET): the program loads FLINT, Arb and GMP where it first calls them, not when it
# starts (docs/decisions.md), and has the property FLINT_ON_DEMAND. They are linked as usual on other systems, and for
# the sanitizers.
function(poinsot_load_flint_on_demand target)
  # Those that others need come first: a library of a prefix of its own is found by the program's path only.
  set(libraries "${GMP_LIBRARY}" "${FLINT_LIBRARY}" "${FLINT_ARB_LIBRARY}")
  if(NOT CMAKE_SYSTEM_NAME STREQUAL "Linux"
     OR NOT CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64"
     OR NOT CMAKE_SIZEOF_VOID_P EQUAL 8
     OR NOT CMAKE_NM
     OR NOT CMAKE_READELF
     OR NOT libraries MATCHES "^[^;]+\\.so;[^;]+\\.so;[^;]+\\.so$"
     OR CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    return()
  endif()
  set(list "${PROJECT_BINARY_DIR}/flint/flint_functions.inc")
  set(archives "$<TARGET_FILE:poinsot_engine>,$<TARGET_FILE:poinsot_problem>")
  list(JOIN libraries "," libraries)
  add_custom_command(
    OUTPUT "${list}"
    COMMAND "${CMAKE_COMMAND}" "-DNM=${CMAKE_NM}" "-DREADELF=${CMAKE_READELF}" "-DARCHIVES=${archives}"
            "-DLIBRARIES=${libraries}" "-DOUTPUT=${list}" -P "${PROJECT_SOURCE_DIR}/cmake/functions_used.cmake"
    DEPENDS poinsot_engine poinsot_problem "${PROJECT_SOURCE_DIR}/cmake/functions_used.cmake"
    COMMENT "Listing the functions of FLINT that are called"
    VERBATIM)
  target_sources(${target} PRIVATE poinsot/flint_on_demand.cpp "${list}")
  target_include_directories(${target} PRIVATE "${PROJECT_BINARY_DIR}/flint")
  # Optimisation of the whole program does not see what stands in assembler.
  set_source_files_properties(poinsot/flint_on_demand.cpp PROPERTIES COMPILE_OPTIONS -fno-lto)
  # What the functions of that file stand for is not linked.
  target_link_options(${target} PRIVATE -Wl,--as-needed)
  target_link_libraries(${target} PRIVATE ${CMAKE_DL_LIBS})
  set_target_properties(${target} PROPERTIES FLINT_ON_DEMAND ON)
endfunction()
