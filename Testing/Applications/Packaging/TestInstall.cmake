# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the build, moves what was installed elsewhere, and uses it there as others would: from
# a project of their own, from the command line, from Python.
#   cmake -DBUILD=<build tree> -DSOURCE=<source tree> -DWORK=<scratch> -DBUILD_TYPE=<type>
#         -DFLAGS=<compiler flags> -DPYTHON=<interpreter, if wrapped> -P TestInstall.cmake
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output
    ERROR_VARIABLE error WORKING_DIRECTORY "${WORK}")
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${output}${error}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_contains text part)
  string(FIND "${text}" "${part}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "Expected '${part}' in:\n${text}")
  endif()
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/first place")
set(prefix "${WORK}/another place")
file(RENAME "${WORK}/first place" "${prefix}")

# No text that is installed names a place of this build.
execute_process(COMMAND grep -rIlF -e "${BUILD}" -e "${SOURCE}" "${prefix}" OUTPUT_VARIABLE named)
if(named)
  message(FATAL_ERROR "The build is named in:\n${named}")
endif()

# --- A project of others ------------------------------------------------------------------------
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/Consumer" -B consumer
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DPEMESH_HEADERS=${prefix}/include/pemesh"
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror ${FLAGS}")
run("${CMAKE_COMMAND}" --build consumer)
# Half of the unit square, cut along its diagonal.
file(WRITE "${WORK}/half.off" "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n")
run(consumer/consumer half.off)
if(NOT output STREQUAL "0.785398163397448\n")
  message(FATAL_ERROR "The smallest angle is a quarter of pi, not ${output}")
endif()
# A module that does not exist is told by name.
file(WRITE "${WORK}/wrong/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(Wrong LANGUAGES C CXX)
find_package(PEMesh REQUIRED COMPONENTS FiltersNonsense)
")
execute_process(COMMAND "${CMAKE_COMMAND}" -S wrong -B wrong "-DCMAKE_PREFIX_PATH=${prefix}"
  WORKING_DIRECTORY "${WORK}" RESULT_VARIABLE status ERROR_VARIABLE error OUTPUT_QUIET)
if(status EQUAL 0)
  message(FATAL_ERROR "A module that does not exist was found.")
endif()
expect_contains("${error}" "FiltersNonsense")

# --- The command line ---------------------------------------------------------------------------
file(WRITE "${WORK}/study.json" [[{
  "pemesh": 1,
  "name": "installed",
  "polygons": [{"family": "star", "center": [0.5, 0.5]}],
  "sweep": [{"parameter": "t", "from": 0, "to": 0.5, "count": 2}],
  "solvers": [{"solver": "pemesh-vem", "problem": "franke"}]
}]])
run("${CMAKE_COMMAND}" -E env PATH=/usr/bin:/bin "${prefix}/bin/pemesh" run study.json)
file(STRINGS "${WORK}/installed/results.csv" rows)
list(LENGTH rows count)
if(NOT count EQUAL 3)
  message(FATAL_ERROR "A heading and two rows were expected: ${rows}")
endif()
foreach(row 1 2)
  list(GET rows ${row} text)
  expect_contains("${text}" "ok")
endforeach()

# --- Python -------------------------------------------------------------------------------------
if(PYTHON)
  file(WRITE "${WORK}/read.py" "import pemesh
reader = pemesh.vtkPEMMeshReader()
reader.SetFileName('half.off')
reader.Update()
print(reader.GetOutput().GetNumberOfCells(), pemesh.__file__)
")
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${prefix}/lib/python3/dist-packages"
    "${PYTHON}" read.py)
  expect_contains("${output}" "1 ${prefix}")
endif()
file(REMOVE_RECURSE "${WORK}")
