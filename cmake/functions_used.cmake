# cmake -DNM=... -DREADELF=... -DARCHIVES=a,b -DLIBRARIES=c,d -DOUTPUT=... -P functions_used.cmake
# Writes FUNCTION(name) for each function of the shared libraries that the archives call, and LIBRARY(file) for each of
# the libraries, as the dynamic linker knows it.
cmake_minimum_required(VERSION 3.25)
foreach(kind ARCHIVES LIBRARIES)
  string(REPLACE "," ";" files_${kind} "${${kind}}")
endforeach()
execute_process(COMMAND "${NM}" --undefined-only ${files_ARCHIVES} OUTPUT_VARIABLE wanted COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${NM}" --dynamic --defined-only ${files_LIBRARIES} OUTPUT_VARIABLE offered
                COMMAND_ERROR_IS_FATAL ANY)
foreach(list wanted offered)
  # Some print the version of a symbol: name@@VERSION.
  string(REGEX MATCHALL "[UTWi] [A-Za-z0-9_]+(@[^\n]*)?\n" ${list} "${${list}}")
  list(TRANSFORM ${list} REPLACE "^. |(@.*)?\n" "")
  list(REMOVE_DUPLICATES ${list})
endforeach()
set(text)
foreach(name IN LISTS wanted)
  if(name IN_LIST offered)
    string(APPEND text "FUNCTION(${name})\n")
  endif()
endforeach()
foreach(library IN LISTS files_LIBRARIES)
  execute_process(COMMAND "${READELF}" --dynamic "${library}" OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
  set(file "${library}")
  if(dynamic MATCHES "\\(SONAME\\)[^\n]*\\[([^\n]+)\\]")
    set(file "${CMAKE_MATCH_1}")
  endif()
  string(APPEND text "LIBRARY(\"${file}\")\n")
endforeach()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${text}" @ONLY) # leaves a file alone that has it already
