# C++ headers of LCM types, made safe against hostile lengths (HardenGeneratedType.cmake). Needs find_package(LCM).

# markservo_generate_types(HEADERS INCLUDE_DIR PACKAGE p TYPES A.lcm ...): rules that write INCLUDE_DIR/p/A.hpp ...; their
# paths in the variable HEADERS. A file holds one type, of its name, in the package p. lcm-gen exits 0 even when it cannot
# write, so the hardening step also proves the file.
function(markservo_generate_types headers include_dir)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "PACKAGE" "TYPES")
  set(written)
  foreach(type_file IN LISTS arg_TYPES)
    get_filename_component(type ${type_file} NAME_WE)
    get_filename_component(source ${type_file} ABSOLUTE)
    set(header ${include_dir}/${arg_PACKAGE}/${type}.hpp)
    add_custom_command(
      OUTPUT ${header}
      COMMAND lcm::gen --cpp --cpp-std=c++11 --cpp-hpath ${include_dir} ${source}
      COMMAND ${CMAKE_COMMAND} -DHEADER=${header} -P ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/HardenGeneratedType.cmake
      DEPENDS ${source} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/HardenGeneratedType.cmake
      COMMENT "lcm-gen ${type}"
      VERBATIM)
    list(APPEND written ${header})
  endforeach()
  set(${headers} ${written} PARENT_SCOPE)
endfunction()

# markservo_lcm_types(NAME PACKAGE p TYPES A.lcm ...): for a project that has found markservo and has types of its own: a
# library to link, with #include <p/A.hpp>. Its types may hold markservo's.
function(markservo_lcm_types name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PACKAGE" "TYPES")
  set(include_dir ${CMAKE_CURRENT_BINARY_DIR}/${name})
  markservo_generate_types(headers ${include_dir} PACKAGE ${arg_PACKAGE} TYPES ${arg_TYPES})
  add_custom_target(${name}_headers DEPENDS ${headers})
  add_library(${name} INTERFACE)
  add_dependencies(${name} ${name}_headers)
  target_include_directories(${name} SYSTEM INTERFACE ${include_dir})
  target_link_libraries(${name} INTERFACE markservo::lcmtypes)
endfunction()
