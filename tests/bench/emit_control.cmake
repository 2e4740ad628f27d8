# Input: SHGEN, FAMILY, RECIPE, FIRST, LAST, OUTPUT. Writes a header with one recipe of a family at some degrees, in the
# namespace sh::control, as <recipe>_<family><Degree>(...): the benchmark's controls are made by the same generator.
string(REPLACE "-" "_" name "${RECIPE}_${FAMILY}")
set(text "// One recipe for every degree, printed by shgen for the benchmark.\n#pragma once\n\n")
string(APPEND text "#include <cmath>\n#include <type_traits>\n#include <utility>\n\nnamespace sh::control::${name}_recipe {\n")
set(choice "")
foreach(degree RANGE ${FIRST} ${LAST})
  execute_process(COMMAND ${SHGEN} emit ${FAMILY} --degree ${degree} --lang cpp --recipe ${RECIPE}
    OUTPUT_VARIABLE kernel RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "shgen emit ${FAMILY} --degree ${degree} --recipe ${RECIPE} failed")
  endif()
  string(REGEX REPLACE "#pragma once|#include <[a-z_]+>|#ifndef SH_GENERATED[A-Z_]*|#define SH_GENERATED[A-Z_]*|#endif" ""
    kernel "${kernel}")
  if(degree GREATER FIRST)
    string(REGEX REPLACE "namespace sh::detail {.*}  // namespace sh::detail" "" kernel "${kernel}")
  endif()
  string(APPEND text "${kernel}")
  string(APPEND choice "  if constexpr (Degree == ${degree}) "
    "sh::control::${name}_recipe::sh::${FAMILY}_l${degree}(std::forward<T>(arguments)...);\n")
endforeach()
string(APPEND text "\n}  // namespace sh::control::${name}_recipe\n\nnamespace sh::control {\n\n"
  "template <int Degree, class... T>\nvoid ${name}(T&&... arguments) {\n${choice}}\n\n}  // namespace sh::control\n")
file(WRITE ${OUTPUT} "${text}")
