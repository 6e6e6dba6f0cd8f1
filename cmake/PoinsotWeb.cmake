# The script and the style of pages, which the program carries inside itself: poinsot_web(TARGET) adds them to a library.
option(POINSOT_WEB "Carry the script of pages (poinsot report); needs Node.js 18 or later and npm" ON)

set(poinsot_web "${PROJECT_SOURCE_DIR}/web")

function(poinsot_web_without target)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/web/no_bundle.cpp"
       CONTENT [[#include "pictures/page/bundle.h"

namespace poinsot::pictures {
const std::string_view page_script, page_style, page_script_hash;
}
]])
  target_sources(${target} PRIVATE "${PROJECT_BINARY_DIR}/web/no_bundle.cpp")
endfunction()

function(poinsot_web target)
  if(NOT POINSOT_WEB)
    poinsot_web_without(${target})
    return()
  endif()
  # The second place is where ./run and ./test put them where nobody has installed them.
  find_program(POINSOT_NODE NAMES node nodejs)
  find_program(POINSOT_NODE NAMES node PATHS "${PROJECT_SOURCE_DIR}/build/node/bin" NO_DEFAULT_PATH)
  find_program(POINSOT_NPM npm)
  find_program(POINSOT_NPM npm PATHS "${PROJECT_SOURCE_DIR}/build/node/bin" NO_DEFAULT_PATH)
  if(NOT POINSOT_NODE OR NOT POINSOT_NPM)
    message(FATAL_ERROR "Pages need Node.js 18 or later and npm, which are not there. Install the packages nodejs and npm "
                        "of your distribution, or configure with -DPOINSOT_WEB=OFF: then `poinsot report` refuses.")
  endif()
  execute_process(COMMAND "${POINSOT_NODE}" --version OUTPUT_VARIABLE node_version OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REPLACE "v" "" node_version "${node_version}")
  if(node_version VERSION_LESS 18)
    message(FATAL_ERROR "Pages need Node.js 18 or later, and ${POINSOT_NODE} is ${node_version}. Install a later one, or "
                        "configure with -DPOINSOT_WEB=OFF: then `poinsot report` refuses.")
  endif()
  # npm writes this list when it is done: another one is made as soon as the wanted packages change.
  set(packages "${poinsot_web}/node_modules/.package-lock.json")
  add_custom_command(
    OUTPUT "${packages}"
    DEPENDS "${poinsot_web}/package-lock.json" "${poinsot_web}/package.json"
    COMMAND "${POINSOT_NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error
    COMMAND "${CMAKE_COMMAND}" -E touch "${packages}"
    WORKING_DIRECTORY "${poinsot_web}"
    COMMENT "Installing the packages of web/package-lock.json")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${poinsot_web}/src/*.ts" "${poinsot_web}/src/*.css")
  set(bundle "${PROJECT_BINARY_DIR}/web/bundle.cpp")
  add_custom_command(
    OUTPUT "${bundle}"
    BYPRODUCTS "${PROJECT_BINARY_DIR}/web/page.js" "${PROJECT_BINARY_DIR}/web/page.css"
    DEPENDS ${sources} "${poinsot_web}/build.mjs" "${packages}"
    COMMAND "${POINSOT_NODE}" "${poinsot_web}/build.mjs" "${PROJECT_BINARY_DIR}/web"
    COMMENT "Bundling the script of pages")
  target_sources(${target} PRIVATE "${bundle}")
endfunction()
