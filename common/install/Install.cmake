# What `cmake --install` lays down, where Debian expects it; two components: `runtime`, and `development` for services in
# other projects. To be included last: it takes what is built.
#   bin/markservo              every command and program by one name: a link to scripts/markservo
#   libexec/markservo/bin      the programs
#   share/markservo            scripts, configuration and types: what a checkout has, so that the scripts are the same; the page
#   lib/systemd/system         the stack as a system's service
#   include/markservo, lib/markservo, lib/cmake/markservo    for find_package(markservo)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(share ${CMAKE_INSTALL_DATADIR}/markservo)
set(libexec ${CMAKE_INSTALL_LIBEXECDIR}/markservo)
set(cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/markservo)
set(written ${PROJECT_BINARY_DIR}/install)

# Programs: every service, and who judges the demo, where it is built.
set(programs)
get_property(services DIRECTORY services PROPERTY SUBDIRECTORIES)
foreach(service IN LISTS services)
  get_property(targets DIRECTORY ${service} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL EXECUTABLE)
      list(APPEND programs ${target})
    endif()
  endforeach()
endforeach()
if(TARGET demo-referee)
  list(APPEND programs demo-referee)
endif()
# In bin, as in a build folder: there is one rule where the scripts look.
install(TARGETS ${programs} RUNTIME DESTINATION ${libexec}/bin COMPONENT runtime)

# Scripts, but those that only a checkout can use, and where an installed tree has its things.
file(RELATIVE_PATH programs_from_share ${CMAKE_INSTALL_FULL_DATADIR}/markservo ${CMAKE_INSTALL_FULL_LIBEXECDIR}/markservo)
file(RELATIVE_PATH command_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_DATADIR}/markservo/scripts/markservo)
configure_file(scripts/lib/installed.sh.in ${written}/installed.sh @ONLY)
file(CREATE_LINK ${command_from_bin} ${written}/markservo SYMBOLIC)
install(DIRECTORY scripts/ DESTINATION ${share}/scripts USE_SOURCE_PERMISSIONS COMPONENT runtime
  REGEX "/scripts/(bench|build|check|experiment|install|test)$" EXCLUDE
  REGEX "/scripts/packages-arm64\\.txt$" EXCLUDE
  REGEX "/scripts/lib/(arm64-[a-z]+|bench-start|breaches\\.sh|check-files|check-layers|debian-mirror\\.sh|installed\\.sh\\.in|java-types|tidy-one)$" EXCLUDE)
install(FILES ${written}/installed.sh DESTINATION ${share}/scripts/lib COMPONENT runtime)
install(DIRECTORY ${PROJECT_BINARY_DIR}/page DESTINATION ${share} COMPONENT runtime OPTIONAL)
install(PROGRAMS ${written}/markservo DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)

# Configuration. The unit as its head says, but by the installed command and as a user of the product's name.
install(DIRECTORY config/ DESTINATION ${share}/config COMPONENT runtime PATTERN "markservo@.service" EXCLUDE)
file(READ config/markservo@.service unit)
string(REPLACE "WorkingDirectory=@repository@\n" "" unit "${unit}")
string(REPLACE "=-@repository@/scripts/" "=-markservo " unit "${unit}")
string(REPLACE "=@repository@/scripts/" "=markservo " unit "${unit}")
string(REPLACE "User=@user@" "User=markservo" unit "${unit}")
file(WRITE ${written}/markservo@.service "${unit}")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS config/markservo@.service)
install(FILES ${written}/markservo@.service DESTINATION lib/systemd/system COMPONENT runtime)

# Types; for lcm-spy also compiled, where there is Java.
install(DIRECTORY lcmtypes/ DESTINATION ${share}/lcmtypes COMPONENT runtime
  FILES_MATCHING PATTERN "*.lcm" PATTERN "channels.yaml" PATTERN "README.md")
find_program(JAVAC javac)
find_program(JAR jar)
find_file(LCM_JAR lcm.jar PATHS /usr/share/java)
set(installable ${programs})
if(JAVAC AND JAR AND LCM_JAR)
  file(GLOB types CONFIGURE_DEPENDS lcmtypes/*.lcm)
  add_custom_command(
    OUTPUT ${written}/types.jar
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/lib/java-types ${LCM_JAR} ${written}/types.jar ${types}
    DEPENDS ${types} scripts/lib/java-types
    COMMENT "compile the types for lcm-spy"
    VERBATIM)
  add_custom_target(java_types ALL DEPENDS ${written}/types.jar)
  install(FILES ${written}/types.jar DESTINATION ${share}/lcmtypes COMPONENT runtime)
  list(APPEND installable java_types)
else()
  message(STATUS "No javac, jar or lcm.jar: an installed `markservo spy` will have no types")
endif()

if(TARGET page)
  list(APPEND installable page)
endif()

# Headers and libraries.
set(libraries bus geometry lcmtypes logging messages motion robot states text)
foreach(library IN LISTS libraries)
  target_include_directories(${library} INTERFACE
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/markservo>)
endforeach()
target_compile_features(lcmtypes INTERFACE cxx_std_17)
install(TARGETS ${libraries} EXPORT markservo-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/markservo COMPONENT development)
install(EXPORT markservo-targets NAMESPACE markservo:: DESTINATION ${cmake_dir} COMPONENT development)
foreach(folder IN ITEMS bus geometry logging messages motion robot states text time)
  install(DIRECTORY common/${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/markservo/common COMPONENT development
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES lcmtypes/channel.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/markservo/lcmtypes COMPONENT development)
install(DIRECTORY ${PROJECT_BINARY_DIR}/lcmtypes/include/markservo DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  COMPONENT development FILES_MATCHING PATTERN "*.hpp")

# Before version 1 every minor version may break (lcmtypes/README.md).
configure_package_config_file(common/install/markservo-config.cmake.in ${written}/markservo-config.cmake
  INSTALL_DESTINATION ${cmake_dir} PATH_VARS share)
write_basic_package_version_file(${written}/markservo-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES
    ${written}/markservo-config.cmake ${written}/markservo-config-version.cmake
    lcmtypes/FindLCM.cmake lcmtypes/GenerateTypes.cmake lcmtypes/HardenGeneratedType.cmake
  DESTINATION ${cmake_dir} COMPONENT development)

install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime RENAME copyright)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}-dev COMPONENT development RENAME copyright)

# All that `cmake --install` and cpack need built.
add_custom_target(installable DEPENDS lcmtypes_headers)
add_dependencies(installable ${installable} bus geometry logging messages motion robot states text)
