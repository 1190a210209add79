# What `cmake --install` puts in place: the program, the static libraries, the headers, and the package `hottel` for
# find_package. What is part of what: `program`, `library`, and `python` (python/CMakeLists.txt).
include(CMakePackageConfigHelpers)

# The library as a whole: what an outside program links.
add_library(hottel_library INTERFACE)
set_target_properties(hottel_library PROPERTIES EXPORT_NAME hottel)
target_link_libraries(hottel_library INTERFACE hottel_viewer)
add_library(hottel::hottel ALIAS hottel_library)

set(layers kernel geometry solver io viewer)
list(TRANSFORM layers PREPEND hottel_ OUTPUT_VARIABLE layer_targets)
install(TARGETS ${layer_targets} hottel_library EXPORT hottel-targets
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library)
install(TARGETS hottel RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)

# Of the headers only hottel.h, those beside it, and what these include. Which these are is found when they are
# installed.
install(CODE "
  set(hottel_root [[${PROJECT_SOURCE_DIR}]])
  set(hottel_include [[${CMAKE_INSTALL_INCLUDEDIR}/hottel]])" COMPONENT library)
install(SCRIPT "${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake" COMPONENT library)

set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/hottel")
install(EXPORT hottel-targets NAMESPACE hottel:: DESTINATION "${package_directory}" COMPONENT library)
configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/hottel-config.cmake.in"
                              "${PROJECT_BINARY_DIR}/hottel-config.cmake" INSTALL_DESTINATION "${package_directory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/hottel-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/hottel-config.cmake" "${PROJECT_BINARY_DIR}/hottel-config-version.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindArb.cmake" "${PROJECT_SOURCE_DIR}/cmake/FindGmpxx.cmake"
        DESTINATION "${package_directory}" COMPONENT library)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_SOURCE_DIR}/CHANGES.md" "${PROJECT_SOURCE_DIR}/README.md"
              "${PROJECT_SOURCE_DIR}/CITATION.cff"
        DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program OPTIONAL)
# What the README points to, where it points to it.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_SOURCE_DIR}/scenes" DESTINATION "${CMAKE_INSTALL_DOCDIR}"
        COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/benchmarks" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program
        FILES_MATCHING PATTERN "*.md" PATTERN "*.csv" PATTERN "*.svg" PATTERN "*.png")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/tests/install/outside" DESTINATION "${CMAKE_INSTALL_DOCDIR}/tests/install"
        COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/tests/users" DESTINATION "${CMAKE_INSTALL_DOCDIR}/tests" USE_SOURCE_PERMISSIONS
        COMPONENT program)

# Manual pages, where there is help2man to make them, and what bash completes.
find_program(HOTTEL_HELP2MAN help2man)
if(HOTTEL_HELP2MAN)
  set(pages "${PROJECT_BINARY_DIR}/man")
  add_custom_command(OUTPUT "${pages}/hottel.1"
    COMMAND "${CMAKE_COMMAND}" -D "program=$<TARGET_FILE:hottel>" -D "help2man=${HOTTEL_HELP2MAN}" -D "out=${pages}"
            -P "${PROJECT_SOURCE_DIR}/cmake/ManPages.cmake"
    DEPENDS hottel "${PROJECT_SOURCE_DIR}/cmake/ManPages.cmake" VERBATIM)
  add_custom_target(hottel_man ALL DEPENDS "${pages}/hottel.1")
  install(DIRECTORY "${pages}/" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program OPTIONAL)
endif()
install(FILES "${PROJECT_SOURCE_DIR}/cli/completion/hottel" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions"
        COMPONENT program)
