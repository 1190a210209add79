# Installs the headers that stand beside hottel.h, it among them, and those of the project that they include, directly
# or not: these are public, and no others.
# hottel_root: where the sources are. hottel_include: where headers go, from the prefix or absolute.
cmake_policy(VERSION 3.25)

# Sets `result` to the headers that are reached from `first`, a list of some of them, as paths from the root.
function(hottel_headers_reached_from first result)
  set(waiting "${first}")
  set(reached "${first}")
  while(waiting)
    list(POP_FRONT waiting header)
    file(STRINGS "${hottel_root}/${header}" lines REGEX "^[ \t]*#[ \t]*include[ \t]*\"")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^[^\"]*\"([^\"]*)\".*" "\\1" included "${line}")
      if(NOT included IN_LIST reached)
        list(APPEND reached "${included}")
        list(APPEND waiting "${included}")
      endif()
    endforeach()
  endwhile()
  set(${result} "${reached}" PARENT_SCOPE)
endfunction()

cmake_path(ABSOLUTE_PATH hottel_include BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}")
file(GLOB first RELATIVE "${hottel_root}" "${hottel_root}/hottel*.h")
hottel_headers_reached_from("${first}" headers)
foreach(header IN LISTS headers)
  cmake_path(GET header PARENT_PATH folder)
  file(INSTALL DESTINATION "${hottel_include}/${folder}" TYPE FILE FILES "${hottel_root}/${header}")
endforeach()
