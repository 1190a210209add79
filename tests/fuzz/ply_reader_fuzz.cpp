// Any bytes as a PLY file: refused with InputError, or a valid scene that is written as a mesh and read again.
#include "tests/fuzz/mesh_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hottel::fuzz_mesh(hottel::MeshFormat3::kPly, {reinterpret_cast<const char*>(data), size});
  return 0;
}
