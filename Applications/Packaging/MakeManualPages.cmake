# SPDX-License-Identifier: GPL-3.0-or-later
# The manual pages, from what the programs say of themselves:
#   cmake -DPROGRAMS=<folder of the programs> -DHELP2MAN=<program> -DOUTPUT=<folder>
#         -DNAMES="<program>;..." -DVERSION=<version> -P MakeManualPages.cmake
# A program with subcommands has a page of its own for each: pemesh-run(1).
cmake_minimum_required(VERSION 3.25)

# Further arguments go to help2man.
function(make_page command page title)
  execute_process(
    COMMAND "${HELP2MAN}" --no-info "--name=${title}" "--output=${OUTPUT}/${page}.1"
      "--version-string=${VERSION}" --source=PEMesh ${ARGN} "${PROGRAMS}/${command}"
    COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(MAKE_DIRECTORY "${OUTPUT}")
foreach(program IN LISTS NAMES)
  execute_process(COMMAND "${PROGRAMS}/${program}" --help OUTPUT_VARIABLE help
    COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE ";" "," help "${help}") # else it separates items of a list
  string(REGEX MATCH "^[^\n]*[^\n.]" title "${help}")
  string(REGEX MATCH "\nSubcommands:\n.*" subcommands "${help}")
  string(REGEX MATCHALL "\n  [a-z]+ [^\n]*" lines "${subcommands}")
  set(others "")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^\n  ([a-z]+) +([^\n]*)" line "${line}")
    set(page "${program}-${CMAKE_MATCH_1}")
    make_page("${program} ${CMAKE_MATCH_1}" "${page}" "${CMAKE_MATCH_2}")
    list(APPEND others "\\fB${page}\\fR(1)")
  endforeach()
  list(JOIN others ",\n" others)
  file(WRITE "${OUTPUT}/see-also" "[SEE ALSO]\n${others}\n")
  make_page("${program}" "${program}" "${title}" "--include=${OUTPUT}/see-also")
  file(REMOVE "${OUTPUT}/see-also")
endforeach()
