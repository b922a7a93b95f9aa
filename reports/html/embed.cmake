# Puts files into the program: superstep_embed(TARGET FILE...) adds a source that defines embedded_file(). A file
# that is not there, such as a chart library that npm could not fetch, is left out.
#
# Run as a script (cmake -DOUTPUT=... -DFILES=a|b -P embed.cmake) it writes that source.

if(CMAKE_SCRIPT_MODE_FILE)
  string(REPLACE "|" ";" files "${FILES}")
  set(arrays "")
  set(branches "")
  set(number 0)
  foreach(file IN LISTS files)
    if(NOT EXISTS "${file}")
      continue()
    endif()
    get_filename_component(name "${file}" NAME)
    file(READ "${file}" bytes HEX)
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${bytes}")
    string(REGEX REPLACE "(......................................................................)" "\\1\n" bytes "${bytes}")
    string(APPEND arrays "constexpr char file_${number}[] = {\n${bytes}'\\0'};\n")
    string(APPEND branches "  if (name == \"${name}\") return {file_${number}, sizeof file_${number} - 1};\n")
    math(EXPR number "${number} + 1")
  endforeach()
  file(WRITE "${OUTPUT}" "// Written by reports/html/embed.cmake.
#include \"reports/html/embedded.hpp\"

namespace superstep {
namespace {

${arrays}
}  // namespace

std::string_view embedded_file([[maybe_unused]] std::string_view name) noexcept {
${branches}  return {};
}

}  // namespace superstep
")
  return()
endif()

function(superstep_embed target)
  set(output ${PROJECT_BINARY_DIR}/generated/embedded_files.cpp)
  set(present "")
  foreach(file IN LISTS ARGN)
    if(EXISTS ${file})
      list(APPEND present ${file})
    endif()
  endforeach()
  list(JOIN present "|" files)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${files}" -P ${PROJECT_SOURCE_DIR}/reports/html/embed.cmake
    DEPENDS ${present} ${PROJECT_SOURCE_DIR}/reports/html/embed.cmake VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
