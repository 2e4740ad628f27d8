# Input: SOURCE_DIR, SCRATCH. Compiles shforge::batch and a consumer for aarch64 (NEON) and runs it in qemu, where a compiler for
# it is installed.
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
find_program(COMPILER aarch64-linux-gnu-g++)
find_program(EMULATOR qemu-aarch64)
find_path(XSIMD xsimd/xsimd.hpp PATHS /usr/include /usr/local/include)
if(NOT COMPILER OR NOT EMULATOR OR NOT XSIMD)
  message("skipped: no aarch64-linux-gnu-g++, qemu-aarch64 or xsimd, `./bootstrap packages` names them")
  return()
endif()
file(REMOVE_RECURSE ${SCRATCH})
# xsimd without the other headers of this machine.
file(MAKE_DIRECTORY ${SCRATCH}/xsimd/include)
file(CREATE_LINK ${XSIMD}/xsimd ${SCRATCH}/xsimd/include/xsimd SYMBOLIC)
file(WRITE ${SCRATCH}/xsimd/xsimdConfig.cmake "add_library(xsimd INTERFACE IMPORTED GLOBAL)
set_target_properties(xsimd PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${SCRATCH}/xsimd/include)
")
file(WRITE ${SCRATCH}/aarch64.cmake "set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER ${COMPILER})
")
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/batch_consumer -B ${SCRATCH}/build -G Ninja
  -D CMAKE_TOOLCHAIN_FILE=${SCRATCH}/aarch64.cmake -D xsimd_DIR=${SCRATCH}/xsimd -D SHFORGE_GENERATED=${SOURCE_DIR}/generated
  -D CMAKE_BUILD_TYPE=Release -D CMAKE_EXE_LINKER_FLAGS=-static)
step(${CMAKE_COMMAND} --build ${SCRATCH}/build)
step(${EMULATOR} ${SCRATCH}/build/batch_consumer)
message("${output}")
