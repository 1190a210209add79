# Ball arithmetic: Arb as a library of its own (libflint-arb), or inside FLINT 3. Defines Arb::Arb.
find_path(Arb_INCLUDE_DIR NAMES arb.h flint/arb.h PATH_SUFFIXES include)
if(Arb_INCLUDE_DIR AND NOT EXISTS "${Arb_INCLUDE_DIR}/arb.h")
  set(Arb_INCLUDE_DIR "${Arb_INCLUDE_DIR}/flint")
endif()
find_path(Flint_INCLUDE_DIR NAMES fmpq.h PATH_SUFFIXES flint)
find_library(Flint_LIBRARY NAMES flint)
find_library(Arb_LIBRARY NAMES arb flint-arb)
find_library(Mpfr_LIBRARY NAMES mpfr)
find_library(Gmp_LIBRARY NAMES gmp)
if(NOT Arb_LIBRARY AND Flint_LIBRARY)
  set(Arb_LIBRARY "${Flint_LIBRARY}")  # FLINT 3 contains Arb
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS Arb_LIBRARY Flint_LIBRARY Mpfr_LIBRARY Gmp_LIBRARY Arb_INCLUDE_DIR Flint_INCLUDE_DIR)
if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb INTERFACE IMPORTED)
  set_target_properties(Arb::Arb PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${Arb_INCLUDE_DIR};${Flint_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${Arb_LIBRARY};${Flint_LIBRARY};${Mpfr_LIBRARY};${Gmp_LIBRARY}")
endif()
mark_as_advanced(Arb_INCLUDE_DIR Flint_INCLUDE_DIR Arb_LIBRARY Flint_LIBRARY Mpfr_LIBRARY Gmp_LIBRARY)
