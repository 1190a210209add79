// The HDF5 library, loaded when a file of it is written or read. Internal to hdf5.cpp.
#pragma once

#include <hdf5.h>

namespace hottel {

// Functions and variables of HDF5, H5Dread as Dread.
// clang-format off
#define HOTTEL_EACH_OF_HDF5(each) \
  each(Aclose) each(Acreate2) each(Aexists) each(Aget_storage_size) each(Aget_type) each(Aopen) each(Aread) \
  each(Awrite) each(Dclose) each(Dcreate2) each(Dget_space) each(Dget_type) each(Dopen2) each(Dread) \
  each(Dvlen_reclaim) each(Dwrite) each(Eget_auto2) each(Eset_auto2) each(Fclose) each(Fcreate) each(Fflush) \
  each(Fopen) each(Lexists) each(Pclose) each(Pcreate) each(Pset_alloc_time) each(Pset_attr_phase_change) \
  each(Pset_chunk) each(Pset_fapl_core) each(Pset_file_image) each(Pset_file_locking) each(Pset_fill_time) \
  each(Pset_libver_bounds) each(Pset_link_creation_order) each(Pset_link_phase_change) each(Pset_obj_track_times) \
  each(Sclose) each(Screate) each(Screate_simple) each(Sget_simple_extent_ndims) each(Sget_simple_extent_npoints) \
  each(Sselect_hyperslab) each(Tclose) each(Tconvert) each(Tcopy) each(Tget_class) each(Tget_size) each(Tget_strpad) \
  each(Tis_variable_str) each(Tset_cset) each(Tset_size) each(Tset_strpad) each(dont_atexit) each(open) \
  each(P_CLS_DATASET_CREATE_ID_g) each(P_CLS_FILE_ACCESS_ID_g) each(P_CLS_FILE_CREATE_ID_g) each(T_C_S1_g) \
  each(T_IEEE_F64LE_g) each(T_NATIVE_DOUBLE_g) each(T_NATIVE_UINT32_g) each(T_NATIVE_UINT64_g) each(T_STD_I8LE_g) \
  each(T_STD_U32LE_g) each(T_STD_U64LE_g)
// clang-format on

struct Hdf5 {
#define HOTTEL_MEMBER(name) decltype(&H5##name) name;
  HOTTEL_EACH_OF_HDF5(HOTTEL_MEMBER)
#undef HOTTEL_MEMBER
};

// Returns HDF5's functions; the first call loads the library and opens it. No program is linked with it, for it brings
// some forty libraries, which would take a third of the start of commands that need none.
//
// Throws RequestError where this machine has not the HDF5 that hottel was built with; what() says what needs it.
const Hdf5& hdf5();

}  // namespace hottel
