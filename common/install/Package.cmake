# Debian packages by `cpack`, in the build folder: markservo and, for services in other projects, markservo-dev. What they
# ask for besides the shared libraries, which dpkg-shlibdeps finds, is in scripts/packages.txt.

# packages_for(OUT ROLE): "a, b, c" of the lines whose second word is ROLE.
function(packages_for out role)
  file(STRINGS scripts/packages.txt lines REGEX "^[a-z0-9.+-]+ +${role}( |$)")
  list(TRANSFORM lines REPLACE " .*" "")
  list(JOIN lines ", " joined)
  set(${out} "${joined}" PARENT_SCOPE)
endfunction()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS scripts/packages.txt)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME markservo)
set(CPACK_PACKAGE_CONTACT "The markservo authors <maintainers@markservo.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "mobile manipulator that works by sight, as small services on LCM")
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "Finds colour-marked objects with two cameras, measures them in 3D, reaches them by visual servoing, grips and lifts them: on a robot, on a simulated one, and on a recorded log.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME markservo)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
packages_for(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS Depends)
packages_for(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS Recommends)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/common/install/prerm)

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Message types and bus, for services in projects of one's own: find_package(markservo) of CMake.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME markservo-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
packages_for(develop Develop)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "markservo (= ${PROJECT_VERSION}), ${develop}")

include(CPack)
