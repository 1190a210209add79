# GMP with its C++ interface. Defines gmp::gmpxx.
find_path(Gmpxx_C_INCLUDE_DIR NAMES gmp.h)
find_path(Gmpxx_INCLUDE_DIR NAMES gmpxx.h)
find_library(Gmpxx_C_LIBRARY NAMES gmp)
find_library(Gmpxx_LIBRARY NAMES gmpxx)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Gmpxx REQUIRED_VARS Gmpxx_C_LIBRARY Gmpxx_LIBRARY Gmpxx_C_INCLUDE_DIR Gmpxx_INCLUDE_DIR)
if(Gmpxx_FOUND AND NOT TARGET gmp::gmpxx)
  add_library(gmp::gmpxx INTERFACE IMPORTED)
  set_target_properties(gmp::gmpxx PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${Gmpxx_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Gmpxx_LIBRARY};${Gmpxx_C_LIBRARY}")
endif()
mark_as_advanced(Gmpxx_C_INCLUDE_DIR Gmpxx_INCLUDE_DIR Gmpxx_C_LIBRARY Gmpxx_LIBRARY)
