# Input: BUILD_DIR, SCRATCH, CONSUMER, COMPILER, SANITIZE. Fails with the output of the step that failed.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
set(flags "")
if(SANITIZE)
  set(flags -fsanitize=address,undefined)
endif()
file(REMOVE_RECURSE ${SCRATCH})
step(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${SCRATCH}/prefix)

# The tools run from there, on what was installed with them.
step(${SCRATCH}/prefix/bin/shcheck eval --degree 4 --order -3 --direction 1,2,3 --digits 40)
if(EXISTS ${SCRATCH}/prefix/bin/shgen)
  file(APPEND ${SCRATCH}/prefix/include/shforge/generated/MANIFEST "basis_l99 appended to the installed list\n")
  step(${CMAKE_COMMAND} -E chdir ${SCRATCH} ${SCRATCH}/prefix/bin/shgen list basis)
  if(NOT output MATCHES "basis_l99 appended")
    message(FATAL_ERROR "shgen list did not read the installed list: ${output}")
  endif()
  step(${SCRATCH}/prefix/bin/shgen emit basis --degree 2 --lang cpp)
endif()

file(COPY ${CONSUMER} DESTINATION ${SCRATCH})
run_consumer(${SCRATCH}/consumer ${SCRATCH}/build -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix -D CMAKE_CXX_FLAGS=${flags})
