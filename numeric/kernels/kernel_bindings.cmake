# Writes the list of bind.hpp into the build folder from the names of the files in generated/cpp: a source file a family,
# with a row a kernel, and one that joins them. The files are configured again when a kernel is added or removed.
#
#   shforge_kernel_bindings(VARIABLE)     VARIABLE: the sources written
function(shforge_kernel_bindings variable)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/bindings)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/generated/cpp
    ${PROJECT_SOURCE_DIR}/generated/cpp/*_l*.hpp)
  list(SORT headers COMPARE NATURAL)
  set(families "")
  foreach(header ${headers})
    if(header MATCHES "^(.+)_l([0-9]+)\\.hpp$")
      set(family ${CMAKE_MATCH_1})
      set(degree ${CMAKE_MATCH_2})
      set(kernel ${family}_l${degree})
      list(APPEND families ${family})
      string(APPEND includes_${family} "#include \"generated/cpp/${header}\"\n")
      string(APPEND rows_${family}
        "      bind<&sh::${kernel}<float>, &sh::${kernel}<double>, &sh::${kernel}<Wide>>(\"${family}\", ${degree}),\n")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES families)
  set(sources ${folder}/all.cpp)
  set(declarations "")
  set(joins "")
  foreach(family ${families})
    file(CONFIGURE OUTPUT ${folder}/${family}.cpp @ONLY CONTENT
      "${includes_${family}}#include \"numeric/kernels/bind.hpp\"\n\nnamespace sh::numeric::bindings {\n\nstd::vector<BoundKernel> ${family}() {\n  return {\n${rows_${family}}  };\n}\n\n}  // namespace sh::numeric::bindings\n")
    list(APPEND sources ${folder}/${family}.cpp)
    string(APPEND declarations "std::vector<BoundKernel> ${family}();\n")
    string(APPEND joins "  for (auto& kernel : bindings::${family}()) all.push_back(std::move(kernel));\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/all.cpp @ONLY CONTENT
    "#include <utility>\n\n#include \"numeric/kernels/bind.hpp\"\n\nnamespace sh::numeric {\nnamespace bindings {\n\n${declarations}\n}  // namespace bindings\n\nstd::vector<BoundKernel> bound_kernels() {\n  std::vector<BoundKernel> all;\n${joins}  return all;\n}\n\n}  // namespace sh::numeric\n")
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()
