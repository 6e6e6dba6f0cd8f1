# Installs the build to a scratch prefix, builds the client there against nothing else, and runs it.
file(REMOVE_RECURSE "${SCRATCH}")
set(prefix "${SCRATCH}/prefix")

execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CLIENT}" -B "${SCRATCH}/client" -G "${GENERATOR}"
                        "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
                        "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DEXPECTED_VERSION=${VERSION}"
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${SCRATCH}/client" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${SCRATCH}/client/client" COMMAND_ERROR_IS_FATAL ANY)

# The installed program knows its version.
execute_process(COMMAND "${prefix}/bin/poinsot" --version
                OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT version STREQUAL "poinsot ${VERSION}")
  message(FATAL_ERROR "the installed program says '${version}', not 'poinsot ${VERSION}'")
endif()
