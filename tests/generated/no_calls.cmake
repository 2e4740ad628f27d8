# cmake -D NM=<nm> -D LIBRARY=<archive> -P no_calls.cmake: fails if a kernel to degree 5 that takes coordinates as lanes is
# called and not inlined. The call would pass them and its constants through memory, which takes up to three times as long.
# The values of higher degrees do not stay in registers anyway.
execute_process(COMMAND ${NM} -C ${LIBRARY} OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${NM} -C ${LIBRARY}: exit status ${status}, expected 0")
endif()
string(REGEX MATCHALL "sh::(basis|basis_gradient|evaluate|evaluate_prepared)_l[0-5]<sh::batch::[^\n]*>\\(" kernels "${symbols}")
if(kernels)
  list(JOIN kernels "\n" kernels)
  message(FATAL_ERROR "${LIBRARY}: expected these kernels to be inlined:\n${kernels}")
endif()
