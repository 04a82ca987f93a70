# Z3::Z3, the solver for nonlinear real arithmetic that the prover asks (libz3-dev on Debian).
find_path(Z3_INCLUDE_DIR z3.h PATH_SUFFIXES z3)
find_library(Z3_LIBRARY z3)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Z3 REQUIRED_VARS Z3_LIBRARY Z3_INCLUDE_DIR)
if(Z3_FOUND AND NOT TARGET Z3::Z3)
  add_library(Z3::Z3 INTERFACE IMPORTED)
  set_target_properties(Z3::Z3 PROPERTIES INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${Z3_INCLUDE_DIR}"
                        INTERFACE_LINK_LIBRARIES "${Z3_LIBRARY}")
endif()
