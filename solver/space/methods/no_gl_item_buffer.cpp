// The item buffer by OpenGL, where this program was built without EGL.
#include "kernel/support/failure.h"
#include "solver/space/methods/item_buffer.h"

namespace hottel {

std::unique_ptr<ItemBuffer3> gl_item_buffer_3(std::uint32_t) {
  throw RequestError("this program was built without EGL; without :egl the hemicube is drawn in software");
}

}  // namespace hottel
