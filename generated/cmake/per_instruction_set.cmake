# shforge_per_instruction_set(TARGET PREFIX SOURCES s.cpp ... OPTIONS o ...): compiles the sources once for each
# instruction set and adds the objects to TARGET. The macro PREFIX_ISA names the set: baseline, avx2 or avx512. The
# compiler contracts where there is FMA (faster, rounds less) unless an option says otherwise. TARGET chooses a set at
# run time; PREFIX_X86 is defined for it where there is a choice. The sources see TARGET's include folders, and xsimd.
function(shforge_per_instruction_set target prefix)
  cmake_parse_arguments(arg "" "" "SOURCES;OPTIONS" ${ARGN})
  string(TOLOWER ${target}_${prefix} objects)
  set(flags_baseline -ffp-contract=off)
  set(flags_avx2 -mavx2 -mfma -mf16c -ffp-contract=fast)
  # g++ 12 warns wrongly on the undefined operands of its own intrinsics (GCC bug 105593).
  set(flags_avx512 -mavx512f -mavx512bw -mavx512dq -mavx512vl -mavx512cd -mfma -mf16c -ffp-contract=fast
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-uninitialized>)
  set(sets baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND sets avx2 avx512)
    target_compile_definitions(${target} PRIVATE ${prefix}_X86)
  endif()
  foreach(isa ${sets})
    add_library(${objects}_${isa} OBJECT ${arg_SOURCES})
    target_compile_features(${objects}_${isa} PRIVATE cxx_std_17)
    target_include_directories(${objects}_${isa} PRIVATE $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_link_libraries(${objects}_${isa} PRIVATE xsimd)
    target_compile_definitions(${objects}_${isa} PRIVATE ${prefix}_ISA=${isa})
    # Kernels in one function with every check of the sanitizers in it would take the compiler minutes to optimise.
    target_compile_options(${objects}_${isa} PRIVATE ${flags_${isa}} ${arg_OPTIONS} $<$<BOOL:${SHFORGE_SANITIZE}>:-O0>)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${objects}_${isa}>)
  endforeach()
endfunction()
