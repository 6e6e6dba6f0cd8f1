# SUNDIALS for stiff equations of motion, where it is installed (libsundials-dev): the sources use it under
# POINSOT_HAS_SUNDIALS. Found file by file, for the distribution's own configuration also wants MPI, PETSc and hypre.
option(POINSOT_SUNDIALS "Use SUNDIALS for stiff motions where it is installed" ON)

if(POINSOT_SUNDIALS)
  find_path(SUNDIALS_INCLUDE cvode/cvode.h)
  set(sundials_libraries)
  foreach(part cvode sunlinsoldense sunmatrixdense nvecserial)
    find_library(SUNDIALS_${part} sundials_${part})
    list(APPEND sundials_libraries "${SUNDIALS_${part}}")
  endforeach()
  find_library(SUNDIALS_CORE sundials_core) # from version 7 on
  if(SUNDIALS_CORE)
    list(APPEND sundials_libraries "${SUNDIALS_CORE}")
  endif()
  if(SUNDIALS_INCLUDE AND NOT "${sundials_libraries}" MATCHES "NOTFOUND")
    target_include_directories(poinsot_engine SYSTEM PRIVATE "${SUNDIALS_INCLUDE}")
    target_link_libraries(poinsot_engine PRIVATE ${sundials_libraries})
    target_compile_definitions(poinsot_engine PRIVATE POINSOT_HAS_SUNDIALS)
  else()
    message(STATUS "SUNDIALS is not there: stiff motions are integrated by the explicit method")
  endif()
endif()
