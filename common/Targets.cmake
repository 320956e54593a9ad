# The three kinds of target in this project; each adds the compiler's strict settings.

# markservo_precompiled(name header lib ...): a header compiled once, which other targets take over; needs these libraries.
function(markservo_precompiled name header)
  if(MARKSERVO_PRECOMPILE)
    # It belongs to a target, and a target has a source.
    add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/common/precompiled/precompiled.cpp)
    target_link_libraries(${name} PRIVATE ${ARGN} markservo_options)
    target_precompile_headers(${name} PRIVATE ${header})
  endif()
endfunction()

# Takes over `precompiled` or `precompiled_tests`.
function(markservo_precompile name header)
  if(TARGET ${header})
    target_precompile_headers(${name} REUSE_FROM ${header})
  endif()
endfunction()

# markservo_vector_code(a.cpp ...): these sources of this folder are compiled once for each vector instruction set (Highway),
# and without the precompiled header: behind one GCC 12 ends with an internal error at the intrinsics of ARM's SVE.
function(markservo_vector_code)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# markservo_library(name SOURCES a.cpp ... LINK lib ... LINK_PRIVATE lib ...): a static library. LINK: what its headers
# need as well.
function(markservo_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;LINK_PRIVATE")
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_LINK_PRIVATE} $<BUILD_INTERFACE:markservo_options>)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  markservo_precompile(${name} precompiled)
endfunction()

# markservo_executable(name SOURCES main.cpp ... LINK lib ...): an executable in <build>/bin.
function(markservo_executable name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} markservo_options)
  markservo_precompile(${name} precompiled)
endfunction()

# markservo_test(name SOURCES a_test.cpp ... LINK lib ... [WHOLE] [ENVIRONMENT NAME=VALUE]): a GoogleTest executable. ctest knows each of its tests
# as NAME.SUITE.TEST, and asks the executable for them when it runs. WHOLE: one entry, since its tests share what costs
# more than they do.
function(markservo_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "WHOLE" "ENVIRONMENT" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest_main markservo_options)
  markservo_precompile(${name} precompiled_tests)
  target_compile_definitions(${name} PRIVATE MARKSERVO_SOURCE_DIR="${PROJECT_SOURCE_DIR}" MARKSERVO_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  if(arg_WHOLE)
    add_test(NAME ${name} COMMAND ${name})
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "${arg_ENVIRONMENT}")
  else()
    gtest_discover_tests(${name} TEST_PREFIX "${name}." DISCOVERY_MODE PRE_TEST NO_PRETTY_VALUES
      PROPERTIES ENVIRONMENT "${arg_ENVIRONMENT}")
  endif()
endfunction()
