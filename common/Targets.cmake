# The three kinds of target in this project; each adds the compiler's strict settings.

# markservo_library(name SOURCES a.cpp ... LINK lib ... LINK_PRIVATE lib ...): a static library. LINK: what its headers
# need as well.
function(markservo_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK;LINK_PRIVATE")
  add_library(${name} STATIC ${arg_SOURCES})
  target_link_libraries(${name} PUBLIC ${arg_LINK} PRIVATE ${arg_LINK_PRIVATE} $<BUILD_INTERFACE:markservo_options>)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
endfunction()

# markservo_executable(name SOURCES main.cpp ... LINK lib ...): an executable in <build>/bin.
function(markservo_executable name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} markservo_options)
endfunction()

# markservo_test(name SOURCES a_test.cpp ... LINK lib ...): a GoogleTest executable that ctest runs as one test.
function(markservo_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINK")
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gtest_main markservo_options)
  target_compile_definitions(${name} PRIVATE MARKSERVO_SOURCE_DIR="${PROJECT_SOURCE_DIR}" MARKSERVO_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  add_test(NAME ${name} COMMAND ${name})
endfunction()
