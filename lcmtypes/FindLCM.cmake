# Debian's liblcm-dev has no CMake package: this finds the library, its headers and lcm-gen, and defines lcm::lcm and lcm::gen.
find_path(LCM_INCLUDE_DIR lcm/lcm-cpp.hpp)
find_library(LCM_LIBRARY lcm)
find_program(LCM_GEN lcm-gen)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LCM
  REQUIRED_VARS LCM_LIBRARY LCM_INCLUDE_DIR LCM_GEN
  REASON_FAILURE_MESSAGE "install Debian's liblcm-dev and liblcm-bin (scripts/packages.txt lists all that is needed)")

if(LCM_FOUND AND NOT TARGET lcm::lcm)
  add_library(lcm::lcm UNKNOWN IMPORTED)
  set_target_properties(lcm::lcm PROPERTIES
    IMPORTED_LOCATION "${LCM_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LCM_INCLUDE_DIR}")
  add_executable(lcm::gen IMPORTED)
  set_target_properties(lcm::gen PROPERTIES IMPORTED_LOCATION "${LCM_GEN}")
endif()
