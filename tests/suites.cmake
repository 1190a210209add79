# Read by ctest: what it runs of a program of tests is a suite at a time, FOLDER.SUITE, for to start a program takes longer
# than most tests do.
cmake_policy(VERSION 3.25)

# Adds the suites of PROGRAM. LONG: suites that are begun first, since they take longest. LABEL: of all of them, or "".
function(hottel_add_suites folder program label)
  if(NOT EXISTS "${program}")
    add_test("${folder}.NOT_BUILT" "${program}")
    return()
  endif()
  execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" lines "${listed}")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "^([^ ]+)\\.($| )")  # "SUITE.", or "SUITE/0.  # TypeParam = ..."; tests are indented
      continue()
    endif()
    set(suite "${CMAKE_MATCH_1}")
    set(name "${folder}.${suite}")
    add_test("${name}" "${program}" "--gtest_filter=${suite}.*" --gtest_brief=1)
    set_tests_properties("${name}" PROPERTIES TIMEOUT 1800 LABELS "${label}")
    if(suite IN_LIST ARGN)
      set_tests_properties("${name}" PROPERTIES COST 1000)
    endif()
  endforeach()
endfunction()
