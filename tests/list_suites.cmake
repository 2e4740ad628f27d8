# Input: PROGRAM, a GoogleTest executable; PREFIX; TOGETHER, a pattern of suites, may be empty; SECONDS that an entry may
# take. Writes to OUTPUT one ctest entry for each suite, PREFIX.Suite, and one, PREFIX.Together, for all suites of the
# pattern.
# A list of tests says nothing about leaks: the sanitizers' suppressions hold when the tests run.
execute_process(COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE lines RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} does not list its tests")
endif()
string(REGEX MATCHALL "(^|\n)[^ \n][^ \n]*\\." suites "${lines}")
set(entries "")
# Entries of minutes start first, in this order: one that starts last runs alone while the other processors wait. ctest
# knows the times of its last run, but a clean checkout has none.
set(long_entries codegen.Shgen numeric.Shcheck prt_emit_shader.Es/EmittedGlsl prt_emit.EmittedCpp
  language.Together)
function(add_entry name filter)
  list(FIND long_entries ${PREFIX}.${name} place)
  set(cost "")
  if(place GREATER_EQUAL 0)
    math(EXPR cost "1000 - ${place}")
    set(cost " COST ${cost}")
  endif()
  string(APPEND entries "add_test([=[${PREFIX}.${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}]=])\n"
    "set_tests_properties([=[${PREFIX}.${name}]=] PROPERTIES TIMEOUT ${SECONDS}${cost})\n")
  set(entries "${entries}" PARENT_SCOPE)
endfunction()
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "\n|\\.$" "" suite "${suite}")
  if(TOGETHER AND suite MATCHES "${TOGETHER}")
    list(APPEND together "${suite}.*")
  else()
    add_entry(${suite} "${suite}.*")
  endif()
endforeach()
if(together)
  list(JOIN together ":" together)
  add_entry(Together "${together}")
endif()
file(WRITE ${OUTPUT} "${entries}")
