# Input: SOURCE_DIR, SCRATCH. Configures with SHFORGE_GENERATOR=OFF and searches the build rules for the generator's libraries.
file(REMOVE_RECURSE ${SCRATCH})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${SCRATCH} -G Ninja -D SHFORGE_GENERATOR=OFF
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${output}")
endif()
file(READ ${SCRATCH}/build.ninja rules)
string(TOLOWER "${rules}" rules)
if(rules MATCHES "ginac|-lcln|libcln")
  message(FATAL_ERROR "a target built without the generator links or includes '${CMAKE_MATCH_0}'")
endif()
