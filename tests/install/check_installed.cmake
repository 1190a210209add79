# Installs the project, builds the outside program against the installed tree, runs it, and looks at what it includes.
# Run as: cmake -D build=TREE -D source=TREE -D work=DIRECTORY -D ... -P check_installed.cmake

# How many headers of the project hottel.h brings at most, itself among them, and how many are installed: those of all
# headers beside it. Each is one more that a reader of the library may have to read, and that cannot be changed at will.
set(most_of_hottel_h 40)
set(public_headers 91)

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

# A closed scene, and an open one, in which the sky is seen.
set(printed "")
foreach(scene triangle_345 strip_obstructed)
  run("${work}/build/outside" "${source}/scenes/analytic/${scene}.json")
  string(APPEND printed "${output}")
endforeach()
file(READ "${source}/tests/install/expected.txt" expected)
if(NOT printed STREQUAL expected)
  message(FATAL_ERROR "The outside program prints\n${printed}instead of\n${expected}")
endif()

# Each header that a program is to include compiles by itself. Ninja keeps what it brings.
file(GLOB first RELATIVE "${source}" "${source}/hottel*.h")
set(alone "${work}/alone")
file(WRITE "${alone}/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)
project(alone LANGUAGES CXX)
find_package(hottel REQUIRED)
file(GLOB sources *.cpp)
add_library(alone OBJECT \${sources})
target_link_libraries(alone PRIVATE hottel::hottel)
")
foreach(header IN LISTS first)
  file(WRITE "${alone}/${header}.cpp" "#include <${header}>\n")
endforeach()
run("${CMAKE_COMMAND}" -S "${alone}" -B "${alone}/build" -G Ninja
    "-DCMAKE_PREFIX_PATH=${work}/prefix" "-DCMAKE_CXX_COMPILER=${compiler}" "-DCMAKE_CXX_FLAGS=${flags}"
    -DCMAKE_DISABLE_FIND_PACKAGE_CGAL=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON)
run("${CMAKE_COMMAND}" --build "${alone}/build")

run("${ninja}" -C "${alone}/build" -t deps CMakeFiles/alone.dir/hottel.h.cpp.o)
string(REGEX MATCHALL "/include/hottel/[^\n]*\n" brought "${output}")
list(LENGTH brought count)
if(count LESS 10 OR count GREATER most_of_hottel_h)
  message(FATAL_ERROR "hottel.h brings ${count} headers; ${most_of_hottel_h} are expected at most:\n${output}")
endif()

run("${ninja}" -C "${alone}/build" -t deps)
if(output MATCHES "/CGAL/|/boost/|/nlohmann/|/arb\\.h|/cairo\\.h|/fmt/")
  message(FATAL_ERROR "An installed header pulls in ${CMAKE_MATCH_0}:\n${output}")
endif()

# The headers that are installed are those that the first ones bring, and as many as are written above.
file(GLOB_RECURSE installed RELATIVE "${work}/prefix/include/hottel" "${work}/prefix/include/*")
foreach(header IN LISTS installed)
  string(FIND "${output}" "/include/hottel/${header}\n" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${header} is installed, and no header beside hottel.h includes it:\n${output}")
  endif()
endforeach()
list(LENGTH installed count)
if(NOT count EQUAL public_headers)
  list(JOIN installed "\n" list)
  message(FATAL_ERROR "${count} headers are installed; ${public_headers} are expected (see the top of this test):\n${list}")
endif()

# The module is imported from where it is installed.
if(python)
  run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${work}/prefix/lib/python3/dist-packages" "${python}" -c
      "import hottel\nprint(hottel.Simulation(hottel.read_scene('${source}/scenes/space/cube.json')).factors)")
  if(NOT output MATCHES "hottel.Factors of 12 faces")
    message(FATAL_ERROR "The installed module prints\n${output}")
  endif()
endif()

# What the installed README points to is there.
file(GLOB readme "${work}/prefix/share/doc/*/README.md")
get_filename_component(doc "${readme}" DIRECTORY)
file(READ "${readme}" text)
string(REPLACE "](" "LINK:" text "${text}")  # lists of CMake count brackets
string(REGEX REPLACE "[][;]" " " text "${text}")
string(REGEX MATCHALL "LINK:[^)#]+" links "${text}")
list(LENGTH links count)
if(count LESS 20)
  message(FATAL_ERROR "The installed README has ${count} links: ${readme}")
endif()
foreach(link IN LISTS links)
  string(SUBSTRING "${link}" 5 -1 link)
  if(NOT link MATCHES "^https?:" AND NOT EXISTS "${doc}/${link}")
    message(FATAL_ERROR "The installed README points to ${link}, which is not installed")
  endif()
endforeach()

# The installed program runs.
run("${work}/prefix/bin/hottel" --version)
