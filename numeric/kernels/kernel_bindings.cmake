# Writes the list of bind.hpp into the build folder from the names of the files in generated/cpp: two source files a group
# of families whose names begin alike, with a row a kernel, one that joins them, and one that holds
# generated/families.json. The files are configured again when a kernel is added or removed.
#
#   shforge_kernel_bindings(VARIABLE)     VARIABLE: the sources written
function(shforge_kernel_bindings variable)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/bindings)
  file(GLOB headers CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/generated/cpp
    ${PROJECT_SOURCE_DIR}/generated/cpp/*_l*.hpp)
  list(SORT headers COMPARE NATURAL)
  set(groups "")
  foreach(header ${headers})
    if(header MATCHES "^(.+)_l([0-9]+)\\.hpp$")
      set(family ${CMAKE_MATCH_1})
      set(degree ${CMAKE_MATCH_2})
      set(kernel ${family}_l${degree})
      string(REGEX REPLACE "_.*" "" group ${family})
      list(APPEND groups ${group})
      string(APPEND includes_${group} "#include \"generated/cpp/${header}\"\n")
      string(APPEND rows_${group} "      bind<&sh::${kernel}<float>, &sh::${kernel}<double>>(\"${family}\", ${degree}),\n")
      string(APPEND wide_rows_${group} "      detail::Binding<Wide, &sh::${kernel}<Wide>>::call,\n")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES groups)
  set(begin "#include \"numeric/kernels/bind.hpp\"\n\nnamespace sh::numeric::bindings {\n\n")
  set(end "\n}  // namespace sh::numeric::bindings\n")
  set(sources ${folder}/all.cpp)
  set(declarations "")
  set(joins "")
  foreach(group ${groups})
    file(CONFIGURE OUTPUT ${folder}/${group}.cpp @ONLY CONTENT
      "${includes_${group}}${begin}std::vector<BoundKernel> ${group}() {\n  return {\n${rows_${group}}  };\n}\n${end}")
    file(CONFIGURE OUTPUT ${folder}/${group}_wide.cpp @ONLY CONTENT
      "${includes_${group}}${begin}std::vector<PointerCall<Wide>> ${group}_wide() {\n  return {\n${wide_rows_${group}}  };\n}\n${end}")
    # Of these only the values matter, and every operation is a call: optimizing takes three times as long for nothing.
    set_source_files_properties(${folder}/${group}_wide.cpp PROPERTIES COMPILE_OPTIONS -O0)
    list(APPEND sources ${folder}/${group}.cpp ${folder}/${group}_wide.cpp)
    string(APPEND declarations "std::vector<BoundKernel> ${group}();\nstd::vector<PointerCall<Wide>> ${group}_wide();\n")
    string(APPEND joins "  append(all, bindings::${group}(), bindings::${group}_wide());\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/all.cpp @ONLY CONTENT
    "${begin}${declarations}${end}\nnamespace sh::numeric {\n\nstd::vector<BoundKernel> bound_kernels() {\n  std::vector<BoundKernel> all;\n${joins}  return all;\n}\n\n}  // namespace sh::numeric\n")
  shforge_families_record(${folder}/families_record.cpp)
  set(${variable} ${sources} ${folder}/families_record.cpp PARENT_SCOPE)
endfunction()

# Writes generated/families.json as an array of its lines: compilers bound the length of one literal.
function(shforge_families_record source)
  set(record ${PROJECT_SOURCE_DIR}/generated/families.json)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${record})
  file(READ ${record} text)
  string(REPLACE "\n" "\n)json\",\nR\"json(" text "${text}")
  file(GENERATE OUTPUT ${source} CONTENT
    "#include \"numeric/kernels/family_record.hpp\"\n\nnamespace sh::numeric {\n\nextern const std::vector<std::string_view> kFamiliesRecordLines;\nconst std::vector<std::string_view> kFamiliesRecordLines = {\nR\"json(${text})json\"};\n\n}  // namespace sh::numeric\n")
endfunction()
