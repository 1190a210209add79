# Installs the project, builds the outside program against the installed tree, runs it, and looks at what it includes.
# Run as: cmake -D build=TREE -D source=TREE -D work=DIRECTORY -D ... -P check_installed.cmake

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\nended with ${code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${work}")
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${work}/prefix")
run("${CMAKE_COMMAND}" -S "${source}/tests/install/outside" -B "${work}/build" -G Ninja
    "-DCMAKE_PREFIX_PATH=${work}/prefix" "-DCMAKE_CXX_COMPILER=${compiler}" "-DCMAKE_CXX_FLAGS=${flags}"
    -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)
run("${CMAKE_COMMAND}" --build "${work}/build")

run("${work}/build/outside" "${source}/scenes/analytic/triangle_345.json")
file(READ "${source}/tests/install/expected.txt" expected)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "The outside program prints\n${output}instead of\n${expected}")
endif()

# The dependency file of the outside program, as Ninja keeps it.
run("${ninja}" -C "${work}/build" -t deps CMakeFiles/outside.dir/main.cpp.o)
if(NOT output MATCHES "hottel/hottel\\.h")
  message(FATAL_ERROR "The dependencies of the outside program are not known:\n${output}")
endif()
if(output MATCHES "/CGAL/|/boost/|/nlohmann/|/arb\\.h|/cairo\\.h|/fmt/")
  message(FATAL_ERROR "An installed header pulls in ${CMAKE_MATCH_0}:\n${output}")
endif()

# The installed program runs.
run("${work}/prefix/bin/hottel" --version)
