# Writes manual pages, hottel.1 and one of each command, from what --help prints.
# Run as: cmake -D program=HOTTEL -D help2man=PROGRAM -D out=DIRECTORY -P ManPages.cmake
cmake_policy(VERSION 3.25)

function(write_page name invocation summary)
  execute_process(COMMAND "${help2man}" --no-info --no-discard-stderr --name "${summary}" --version-string "${version}"
                          --output "${out}/${name}.1" "${invocation}"
                  RESULT_VARIABLE code ERROR_VARIABLE error)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "help2man cannot write ${name}.1: ${error}")
  endif()
  # A page is called as one calls the command.
  file(READ "${out}/${name}.1" text)
  string(REPLACE "${program}" "hottel" text "${text}")
  string(REGEX REPLACE "(\n\\.SH NAME\n)hottel ([a-z]+) " "\\1hottel-\\2 " text "${text}")
  file(WRITE "${out}/${name}.1" "${text}")
endfunction()

execute_process(COMMAND "${program}" --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "^hottel " "" version "${version}")
execute_process(COMMAND "${program}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE "${out}")
file(MAKE_DIRECTORY "${out}")
write_page(hottel "${program}" "the exact reference for diffuse light")

string(REGEX REPLACE "^.*\nSubcommands:\n" "" commands "${help}")
string(REPLACE ";" "," commands "${commands}")
string(REGEX MATCHALL "(^|\n)  [a-z]+ +[^\n]+" commands "${commands}")
foreach(line IN LISTS commands)
  string(REGEX MATCH "  ([a-z]+) +(.*)$" line "${line}")
  write_page("hottel-${CMAKE_MATCH_1}" "${program} ${CMAKE_MATCH_1}" "${CMAKE_MATCH_2}")
endforeach()
