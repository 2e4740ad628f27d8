# Input: SOURCE_DIR, SCRATCH, COMPILER. Uses generated/ alone where no other package is in sight: by FetchContent, by
# add_subdirectory, and installed. Searches what was compiled for headers of other libraries.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
set(consumer ${CMAKE_CURRENT_LIST_DIR}/generated_consumer)
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/prefix)
# find_package and its like look into this folder only.
set(alone -D CMAKE_FIND_ROOT_PATH=${SCRATCH}/prefix)
foreach(kind PACKAGE LIBRARY INCLUDE)
  list(APPEND alone -D CMAKE_FIND_ROOT_PATH_MODE_${kind}=ONLY)
endforeach()

run_consumer(${consumer} ${SCRATCH}/fetch ${alone} -D HOW=fetch -D FETCHCONTENT_SOURCE_DIR_SHFORGE=${SOURCE_DIR})
run_consumer(${consumer} ${SCRATCH}/subdirectory ${alone} -D HOW=subdirectory -D SHFORGE=${SOURCE_DIR})
step(${CMAKE_COMMAND} -S ${SOURCE_DIR}/generated -B ${SCRATCH}/generated -G Ninja ${alone}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_INSTALL_PREFIX=${SCRATCH}/prefix)
step(${CMAKE_COMMAND} --build ${SCRATCH}/generated --target install)
run_consumer(${consumer} ${SCRATCH}/package ${alone} -D HOW=package)

foreach(how fetch subdirectory package)
  step(ninja -C ${SCRATCH}/${how} -t deps)
  if(output MATCHES "[^\n]*/(ginac|cln|embree3|xsimd|assimp|fmt|boost|eigen3)/[^\n]*")
    message(FATAL_ERROR "${how}: expected no header of another library, got ${CMAKE_MATCH_0}")
  endif()
  if(NOT output MATCHES "cpp/basis_l4\\.hpp")
    message(FATAL_ERROR "${how}: expected basis_l4.hpp among the headers, got ${output}")
  endif()
endforeach()

# The library over many records asks for xsimd when it is wanted.
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE_DIR}/generated -B ${SCRATCH}/batch -G Ninja ${alone}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D SHFORGE_BATCH=ON RESULT_VARIABLE code OUTPUT_QUIET ERROR_VARIABLE output)
if(code EQUAL 0 OR NOT output MATCHES "xsimd")
  message(FATAL_ERROR "SHFORGE_BATCH=ON without xsimd: expected an error that names xsimd, got ${output}")
endif()
