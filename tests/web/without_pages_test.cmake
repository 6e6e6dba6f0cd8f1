# Configures the project without pages, where there is neither Node.js nor npm, and compiles what stands in their place.
file(REMOVE_RECURSE "${SCRATCH}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${SCRATCH}" -G "${GENERATOR}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
          -DPOINSOT_WEB=OFF -DPOINSOT_NODE=POINSOT_NODE-NOTFOUND -DPOINSOT_NPM=POINSOT_NPM-NOTFOUND -DPOINSOT_PYTHON=OFF
  OUTPUT_VARIABLE told ERROR_VARIABLE told RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "it cannot be configured without pages:\n${told}")
endif()
if(EXISTS "${SCRATCH}/web/page.js" OR EXISTS "${SCRATCH}/web/bundle.cpp")
  message(FATAL_ERROR "it carries the script of pages, which was not wanted")
endif()
execute_process(COMMAND "${COMPILER}" -std=c++20 -fsyntax-only "-I${SOURCE}/src" "-I${SOURCE}/include"
                        "${SCRATCH}/web/no_bundle.cpp"
                ERROR_VARIABLE told RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "what stands in place of the script does not compile:\n${told}")
endif()
file(GLOB_RECURSE lists "${SCRATCH}/CTestTestfile.cmake" "${SCRATCH}/tests/CTestTestfile.cmake")
foreach(list IN LISTS lists)
  file(STRINGS "${list}" browsers REGEX "web_(text|files|pages)")
  if(browsers)
    message(FATAL_ERROR "tests of pages are left: ${browsers}")
  endif()
endforeach()
