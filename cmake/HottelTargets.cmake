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

# hottel_precompile(TARGET HEADERS...): these headers, of libraries that most sources of the target include, are read
# once. Sources include what they use all the same: builds without HOTTEL_PRECOMPILED_HEADERS see to that.
function(hottel_precompile target)
  if(HOTTEL_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional>
                              <set> <span> <string> <string_view> <variant> <vector> ${ARGN})
  endif()
endfunction()

# hottel_layer(NAME PUBLIC libs... PRIVATE libs... EXCEPT sources...): the folder NAME/, but for these sources, as the
# library hottel_NAME.
function(hottel_layer name)
  cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE;EXCEPT" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${name}/*.cpp")
  list(TRANSFORM arg_EXCEPT PREPEND "${PROJECT_SOURCE_DIR}/")
  list(REMOVE_ITEM sources ${arg_EXCEPT})
  if(sources)
    add_library(hottel_${name} STATIC ${sources})
    hottel_compile_options(hottel_${name})
    hottel_precompile(hottel_${name} <gmpxx.h>)
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
