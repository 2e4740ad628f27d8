# Input: FOLDER, the build folder. Prints the rows that Extreme tests wrote since the last time (tests/numeric/extreme.hpp),
# sorted, and keeps them as extremes.txt; without any it prints nothing. ctest runs it after the tests (CTestCustom.cmake).
set(part ${FOLDER}/extremes.part)
if(EXISTS ${part})
  execute_process(COMMAND sort -u ${part} OUTPUT_VARIABLE rows)
  file(REMOVE ${part})
  string(REPEAT " " 68 space)
  file(WRITE ${FOLDER}/extremes.txt "extreme | what${space} |      error |      limit | worst input\n${rows}")
  execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${FOLDER}/extremes.txt)
endif()
