# poinsot_embedded_text(VARIABLE FILE NAME): a source that holds the text of a file as `const std::string_view NAME` of
# namespace poinsot::document. Its path is put into VARIABLE.
function(poinsot_embedded_text variable file name)
  set(source "${PROJECT_BINARY_DIR}/embedded/${name}.cpp")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
  file(READ "${file}" text)
  string(CONCAT source_text
         "#include <string_view>\n\n"
         "namespace poinsot::document {\n\n"
         "extern const std::string_view ${name};\n"
         "const std::string_view ${name} = R\"embedded(${text})embedded\";\n\n"
         "}  // namespace poinsot::document\n")
  set(before)
  if(EXISTS "${source}")
    file(READ "${source}" before)
  endif()
  # A source that is the same keeps its time, so that nothing is compiled again.
  if(NOT "${before}" STREQUAL "${source_text}")
    file(WRITE "${source}" "${source_text}")
  endif()
  set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set(${variable} "${source}" PARENT_SCOPE)
endfunction()
