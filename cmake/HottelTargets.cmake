# What every target of the project is compiled with, and how a layer becomes a library.

function(hottel_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
  # g++ 12 warns falsely of std::string operator+ (GCC bug 105651).
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>")
  if(HOTTEL_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  # Results must not depend on how the compiler contracts or reorders floating-point operations.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

# hottel_precompile(TARGET HEADERS...): these headers, of libraries that most sources of the target include, are read once.
# hottel_precompile(TARGET WITH OTHER): those of another target, which has the same compiler options, are read once for both.
# Sources include what they use all the same: builds without HOTTEL_BATCHES see to that.
function(hottel_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "WITH" "")
  if(NOT HOTTEL_BATCHES)
    return()
  endif()
  if(arg_WITH)
    target_precompile_headers(${target} REUSE_FROM ${arg_WITH})
  else()
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional>
                              <set> <span> <string> <string_view> <variant> <vector> ${arg_UNPARSED_ARGUMENTS})
  endif()
endfunction()

# hottel_batch(TARGET SOURCES...): these sources of the target are compiled eight at a time, folder by folder, so that
# headers and templates are read once for all of them. Names that are local to a source must differ within its folder.
function(hottel_batch target)
  if(NOT HOTTEL_BATCHES)
    return()
  endif()
  set(folder_before "")
  foreach(source IN LISTS ARGN)
    cmake_path(GET source PARENT_PATH folder)
    if(NOT folder STREQUAL folder_before)
      set(folder_before "${folder}")
      set(place 0)
    endif()
    math(EXPR batch "${place} / 8")
    math(EXPR place "${place} + 1")
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${PROJECT_SOURCE_DIR}" OUTPUT_VARIABLE name)
    string(MAKE_C_IDENTIFIER "${name}_${batch}" name)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${name}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A class may have members of a source's local types, which g++ sees only of sources that are not included.
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>")
  # A name in a function may be a local one of a neighbour too, which clang tells.
  target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>")
endfunction()

# hottel_layer(NAME PUBLIC libs... PRIVATE libs... EXCEPT sources... ALONE folders...): the folder NAME/, but for these
# sources, as the library hottel_NAME. It is compiled in batches, but for these folders and for sources that have compiler
# options of their own.
function(hottel_layer name)
  cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE;EXCEPT;ALONE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${name}/*.cpp")
  list(TRANSFORM arg_EXCEPT PREPEND "${PROJECT_SOURCE_DIR}/")
  list(REMOVE_ITEM sources ${arg_EXCEPT})
  if(sources)
    add_library(hottel_${name} STATIC ${sources})
    hottel_compile_options(hottel_${name})
    if(HOTTEL_PYTHON)  # the module is a shared object
      set_target_properties(hottel_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
      target_compile_options(hottel_${name} PRIVATE -fno-semantic-interposition)  # as fast as without
    endif()
    hottel_precompile(hottel_${name} <gmpxx.h>)
    set(batched ${sources})
    foreach(folder IN LISTS arg_ALONE)
      list(FILTER batched EXCLUDE REGEX "^${PROJECT_SOURCE_DIR}/${name}/${folder}/")
    endforeach()
    hottel_batch(hottel_${name} ${batched})
    target_include_directories(hottel_${name} PUBLIC
      "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/hottel>")
    target_compile_features(hottel_${name} PUBLIC cxx_std_20)
    target_link_libraries(hottel_${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
  else()
    add_library(hottel_${name} INTERFACE)
    target_link_libraries(hottel_${name} INTERFACE ${arg_PUBLIC})
  endif()
  set_target_properties(hottel_${name} PROPERTIES EXPORT_NAME ${name})
  add_library(hottel::${name} ALIAS hottel_${name})
endfunction()
