# Makes the Debian packages, looks at what they say and hold, and runs what is in them from where they are unpacked.
# Run as: cmake -D build=TREE -D work=DIRECTORY -D python=PROGRAM -D source=TREE -P check_packages.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if(NOT code EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\nended with ${code}:\n${output}${error}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}")
run("${CMAKE_CPACK_COMMAND}" --config "${build}/CPackConfig.cmake" -B "${work}/packages"
    -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip)

# expect(PACKAGE FIELD PATTERN FILES...): the field of the package's control file, and files that are in it.
function(expect package field pattern)
  file(GLOB file "${work}/packages/${package}_*.deb")
  run(dpkg-deb --field "${file}" ${field})
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${package} has the ${field} ${output} and not ${pattern}")
  endif()
  run(dpkg-deb --contents "${file}")
  foreach(wanted IN LISTS ARGN)
    if(NOT output MATCHES " \\./usr/${wanted}[^\n/]*\n")
      message(FATAL_ERROR "${package} has no ${wanted}:\n${output}")
    endif()
  endforeach()
  if(output MATCHES " \\./(usr/local|home|root|tmp|work)/")
    message(FATAL_ERROR "${package} has files in ${CMAKE_MATCH_1}:\n${output}")
  endif()
  run(dpkg-deb --extract "${file}" "${work}/root")
endfunction()
if(EXISTS "${build}/man/hottel.1")  # made where there is help2man
  set(pages share/man/man1/hottel.1 share/man/man1/hottel-factors.1)
endif()
expect(hottel Recommends "libhdf5.*libsdl2")
expect(python3-hottel Recommends "libhdf5.*python3-scipy")
expect(hottel Depends "libcairo2.*libgmp10" ${pages} bin/hottel share/doc/hottel/README.md
       share/bash-completion/completions/hottel share/doc/hottel/docs/python.md)
expect(libhottel-dev Depends "libgmp-dev.*libtbb-dev" lib/libhottel_kernel.a lib/libhottel_viewer.a include/hottel/hottel.h
       include/hottel/hottel_pictures.h lib/cmake/hottel/hottel-config.cmake)
expect(python3-hottel Depends "python3 \\(>= 3.*python3-numpy.*libgmp10" lib/python3/dist-packages/hottel/__init__.py
       lib/python3/dist-packages/hottel/_core lib/python3/dist-packages/hottel/py.typed)

run("${work}/root/usr/bin/hottel" --version)
run("${CMAKE_COMMAND}" -E env "PYTHONPATH=${work}/root/usr/lib/python3/dist-packages" "${python}" -c
    "import hottel\nprint(hottel.__file__, hottel.Simulation(hottel.read_scene('${source}/scenes/space/cube.json')).factors)")
if(NOT output MATCHES "^${work}/root/.*hottel.Factors of 12 faces")
  message(FATAL_ERROR "The module of the package prints\n${output}")
endif()
file(REMOVE_RECURSE "${work}")
