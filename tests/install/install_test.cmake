# Installs the build to scratch prefixes, builds the clients there against nothing else, and runs them.
file(REMOVE_RECURSE "${SCRATCH}")

# installed(PREFIX [COMPONENT...]): the whole build, or some components of it.
function(installed prefix)
  if(NOT ARGN)
    execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}"
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endif()
  foreach(component IN LISTS ARGN)
    execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}" --component "${component}"
                    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
endfunction()

# A client finds the package without those that are named: to ask for one of them is an error.
function(client_runs name prefix)
  list(TRANSFORM ARGN REPLACE "^(.+)$" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON" OUTPUT_VARIABLE without)
  execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CLIENTS}/${name}" -B "${SCRATCH}/${name}" -G "${GENERATOR}"
                          "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
                          "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS=${FLAGS}"
                          "-DEXPECTED_VERSION=${VERSION}" ${without}
                  COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${CMAKE_COMMAND}" --build "${SCRATCH}/${name}" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND "${SCRATCH}/${name}/client" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# The engine alone, without anything that problems need.
set(prefix "${SCRATCH}/engine")
installed("${prefix}" engine)
if(EXISTS "${prefix}/include/poinsot/problem.h")
  message(FATAL_ERROR "the engine was installed with headers for problems")
endif()
client_runs(engine_client "${prefix}" yaml-cpp nlohmann_json HDF5 CLI11 Eigen3 Boost)
# Problems are not there, and that is said.
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CLIENTS}/problem_client" -B "${SCRATCH}/without_problem"
                        -G "${GENERATOR}" "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
                        "-DEXPECTED_VERSION=${VERSION}"
                RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE message)
if(NOT failed OR NOT message MATCHES "problem")
  message(FATAL_ERROR "a client of problems was content with the engine alone: ${message}")
endif()

# Everything.
set(prefix "${SCRATCH}/prefix")
installed("${prefix}")
client_runs(problem_client "${prefix}" nlohmann_json HDF5 CLI11 Eigen3 Boost)
file(GLOB_RECURSE headers RELATIVE "${SOURCE}/include" "${SOURCE}/include/*")
file(GLOB_RECURSE installed_headers RELATIVE "${prefix}/include" "${prefix}/include/*")
if(NOT headers STREQUAL installed_headers)
  message(FATAL_ERROR "installed headers are not those of include/: ${installed_headers}")
endif()

# The installed program knows its version.
execute_process(COMMAND "${prefix}/bin/poinsot" --version
                OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT version STREQUAL "poinsot ${VERSION}")
  message(FATAL_ERROR "the installed program says '${version}', not 'poinsot ${VERSION}'")
endif()
