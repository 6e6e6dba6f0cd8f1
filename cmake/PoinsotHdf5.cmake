# HDF5, for recordings: HDF5_LIBRARIES and HDF5_INCLUDE. By hand: FindHDF5 needs the C language, here and in every
# project that uses poinsot. The static library is taken where it links with the compression libraries alone: a
# distribution's shared one reaches for remote files too and so brings some forty libraries (curl, TLS, Kerberos), which
# would cost every run of the program more than half of its start.
find_library(HDF5_SHARED NAMES hdf5_serial hdf5 REQUIRED)
find_path(HDF5_INCLUDE hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED)
find_library(HDF5_STATIC NAMES libhdf5_serial.a libhdf5.a)
mark_as_advanced(HDF5_SHARED HDF5_INCLUDE HDF5_STATIC)

set(HDF5_LIBRARIES "${HDF5_SHARED}")
if(HDF5_STATIC)
  set(hdf5_static_libraries "${HDF5_STATIC}")
  foreach(part sz aec z)
    find_library(HDF5_STATIC_${part} NAMES lib${part}.a ${part})
    mark_as_advanced(HDF5_STATIC_${part})
    if(HDF5_STATIC_${part})
      list(APPEND hdf5_static_libraries "${HDF5_STATIC_${part}}")
    endif()
  endforeach()
  list(APPEND hdf5_static_libraries ${CMAKE_DL_LIBS} m)

  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_INCLUDES "${HDF5_INCLUDE}")
  set(CMAKE_REQUIRED_LIBRARIES "${hdf5_static_libraries}")
  check_cxx_source_compiles(
      "#include <hdf5.h>
       int main() { return H5Fclose(H5Fcreate(\"\", H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) < 0; }"
      HDF5_STATIC_LINKS)
  unset(CMAKE_REQUIRED_INCLUDES)
  unset(CMAKE_REQUIRED_LIBRARIES)
  if(HDF5_STATIC_LINKS)
    set(HDF5_LIBRARIES "${hdf5_static_libraries}")
  endif()
endif()

# The static library is not compiled for shared objects: a target that is one says so by this property of its own.
if(NOT HDF5_LIBRARIES STREQUAL HDF5_SHARED)
  set(hdf5_for_programs ${HDF5_LIBRARIES})
  set(shared "$<BOOL:$<TARGET_PROPERTY:POINSOT_SHARED_OBJECT>>")
  set(HDF5_LIBRARIES "$<${shared}:${HDF5_SHARED}>")
  foreach(library ${hdf5_for_programs})
    list(APPEND HDF5_LIBRARIES "$<$<NOT:${shared}>:${library}>")
  endforeach()
endif()
