# FLINT and Arb: polynomials over the integers, real numbers with error bounds. Defines FLINT::FLINT.
find_path(FLINT_INCLUDE_DIR flint/fmpz_mpoly_factor.h)
find_path(FLINT_ARB_INCLUDE_DIR arb.h)
find_library(FLINT_LIBRARY flint)
find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
find_library(GMP_LIBRARY gmp) # inline functions of FLINT's headers call it
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_ARB_INCLUDE_DIR FLINT_LIBRARY FLINT_ARB_LIBRARY GMP_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS FLINT_LIBRARY FLINT_ARB_LIBRARY GMP_LIBRARY FLINT_INCLUDE_DIR
                                                      FLINT_ARB_INCLUDE_DIR
                                  REASON_FAILURE_MESSAGE "Debian's packages are libflint-dev and libflint-arb-dev")
if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT INTERFACE IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES
                        INTERFACE_INCLUDE_DIRECTORIES "${FLINT_INCLUDE_DIR};${FLINT_ARB_INCLUDE_DIR}"
                        INTERFACE_LINK_LIBRARIES "${FLINT_ARB_LIBRARY};${FLINT_LIBRARY};${GMP_LIBRARY}")
endif()
