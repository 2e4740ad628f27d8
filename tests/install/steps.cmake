# step(COMMAND...): runs it; fails with its output. The output is in `output`.
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# run_consumer(SOURCE BUILD CONFIGURE_OPTIONS...): configures, builds and runs a consumer, which has to print "agree".
function(run_consumer source build)
  step(${CMAKE_COMMAND} -S ${source} -B ${build} -G Ninja -D CMAKE_CXX_COMPILER=${COMPILER} ${ARGN})
  step(${CMAKE_COMMAND} --build ${build})
  step(${build}/consumer)
  if(NOT output MATCHES "agree")
    message(FATAL_ERROR "${source}: expected the consumer to print agree, got ${output}")
  endif()
endfunction()
