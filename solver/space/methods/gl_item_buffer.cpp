// The item buffer by OpenGL, drawn without a window through EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "kernel/support/failure.h"
#include "solver/space/methods/item_buffer.h"

namespace hottel {
namespace {

// How much nearer than the farthest corner what is seen may be: depths are floats near 0, with all their digits.
constexpr double kNearest = 0x1p-40;

constexpr const char* kVertexShader = R"(#version 450 core
layout(location = 0) in vec3 seen;
layout(location = 1) in uint label;
uniform float nearest;
flat out uint item;
void main() {
  gl_Position = vec4(seen.x, seen.y, nearest, seen.z);  // depth: nearest / distance
  item = label;
}
)";
constexpr const char* kFragmentShader = R"(#version 450 core
flat in uint item;
layout(location = 0) out uint shown;
void main() { shown = item; }
)";

[[noreturn]] void refuse(const std::string& what) {
  throw RequestError("no OpenGL 4.5 through EGL: " + what + "; without :egl the hemicube is drawn in software");
}

template <class Function>
Function function_called(const char* name) {
  const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (function == nullptr) refuse(std::string(name) + " is missing");
  return function;
}

// The functions that are used, as the driver has them.
struct OpenGl {
#define HOTTEL_GL(type, name) type name = function_called<type>("gl" #name)
  HOTTEL_GL(PFNGLATTACHSHADERPROC, AttachShader);
  HOTTEL_GL(PFNGLBINDBUFFERPROC, BindBuffer);
  HOTTEL_GL(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer);
  HOTTEL_GL(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer);
  HOTTEL_GL(PFNGLBINDVERTEXARRAYPROC, BindVertexArray);
  HOTTEL_GL(PFNGLBUFFERDATAPROC, BufferData);
  HOTTEL_GL(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus);
  HOTTEL_GL(PFNGLCLEARBUFFERFVPROC, ClearBufferfv);
  HOTTEL_GL(PFNGLCLEARBUFFERUIVPROC, ClearBufferuiv);
  HOTTEL_GL(PFNGLCLIPCONTROLPROC, ClipControl);
  HOTTEL_GL(PFNGLCOMPILESHADERPROC, CompileShader);
  HOTTEL_GL(PFNGLCREATEPROGRAMPROC, CreateProgram);
  HOTTEL_GL(PFNGLCREATESHADERPROC, CreateShader);
  HOTTEL_GL(PFNGLDEPTHFUNCPROC, DepthFunc);
  HOTTEL_GL(PFNGLDRAWARRAYSPROC, DrawArrays);
  HOTTEL_GL(PFNGLENABLEPROC, Enable);
  HOTTEL_GL(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray);
  HOTTEL_GL(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer);
  HOTTEL_GL(PFNGLGENBUFFERSPROC, GenBuffers);
  HOTTEL_GL(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers);
  HOTTEL_GL(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers);
  HOTTEL_GL(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays);
  HOTTEL_GL(PFNGLGETERRORPROC, GetError);
  HOTTEL_GL(PFNGLGETPROGRAMIVPROC, GetProgramiv);
  HOTTEL_GL(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation);
  HOTTEL_GL(PFNGLLINKPROGRAMPROC, LinkProgram);
  HOTTEL_GL(PFNGLPIXELSTOREIPROC, PixelStorei);
  HOTTEL_GL(PFNGLREADPIXELSPROC, ReadPixels);
  HOTTEL_GL(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage);
  HOTTEL_GL(PFNGLSHADERSOURCEPROC, ShaderSource);
  HOTTEL_GL(PFNGLUNIFORM1FPROC, Uniform1f);
  HOTTEL_GL(PFNGLUSEPROGRAMPROC, UseProgram);
  HOTTEL_GL(PFNGLVERTEXATTRIBIPOINTERPROC, VertexAttribIPointer);
  HOTTEL_GL(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer);
  HOTTEL_GL(PFNGLVIEWPORTPROC, Viewport);
#undef HOTTEL_GL
};

// A context without a surface. What is made in it goes with it.
class GlContext {
 public:
  GlContext() {
    display_ = display();
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) refuse("no display");
    constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    constexpr EGLint kVersion[] = {
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglChooseConfig(display_, kConfig, &config, 1, &count) == EGL_FALSE || count == 0)
      refuse("it does not draw for OpenGL");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, kVersion);
    if (context_ == EGL_NO_CONTEXT) refuse("no context of that version");
  }
  // The display is not terminated: it is one for all contexts of the process.
  ~GlContext() { eglDestroyContext(display_, context_); }
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  void enter() const {
    eglBindAPI(EGL_OPENGL_API);  // by thread
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      refuse("it does not draw without a window");
  }
  void leave() const { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT); }

 private:
  static EGLDisplay display() {
    const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay without_window = EGL_NO_DISPLAY;
    if (get != nullptr) without_window = get(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return without_window != EGL_NO_DISPLAY ? without_window : eglGetDisplay(EGL_DEFAULT_DISPLAY);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

// While it lives this thread draws in the context.
class Entered {
 public:
  explicit Entered(const GlContext& context) : context_(context) { context.enter(); }
  ~Entered() { context_.leave(); }
  Entered(const Entered&) = delete;
  Entered& operator=(const Entered&) = delete;

 private:
  const GlContext& context_;
};

struct Corner {
  float seen[3];
  std::uint32_t label;
};

class GlItemBuffer3 final : public ItemBuffer3 {
 public:
  explicit GlItemBuffer3(std::uint32_t resolution)
      : resolution_(static_cast<GLsizei>(resolution)), label_(std::size_t{resolution} * resolution) {
    const Entered entered(context_);
    make_target();
    make_program();
    make_corners();
    gl_.Viewport(0, 0, resolution_, resolution_);
    gl_.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_GREATER);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
    require_no_error();
  }

  std::span<const std::uint32_t> draw(const ElementPatch3& patch, const CubeSide3& side, const SideElements3& items,
                                      std::uint32_t background) override {
    corners_.clear();
    double farthest = 0;
    for_items_3(patch, side, items, [&](std::span<const Vector3d> seen, std::uint32_t label) {
      if (std::all_of(seen.begin(), seen.end(), [](const Vector3d& c) { return c.z <= 0; })) return;
      for (const Vector3d& c : seen) farthest = std::max(farthest, std::fabs(c.z));
      for (std::size_t k = 2; k < seen.size(); ++k)
        for (const std::size_t corner : {std::size_t{0}, k - 1, k}) add_corner(seen[corner], label);
    });
    const Entered entered(context_);
    const GLfloat no_depth = 0;
    gl_.ClearBufferuiv(GL_COLOR, 0, &background);
    gl_.ClearBufferfv(GL_DEPTH, 0, &no_depth);
    gl_.Uniform1f(nearest_, static_cast<float>(kNearest * farthest));
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(Corner)), corners_.data(),
                   GL_STREAM_DRAW);
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size()));
    const auto first_row = static_cast<GLint>(side.first_row);
    gl_.ReadPixels(0, first_row, resolution_, resolution_ - first_row, GL_RED_INTEGER, GL_UNSIGNED_INT, label_.data());
    require_no_error();
    return std::span(label_).first(static_cast<std::size_t>(resolution_) *
                                   static_cast<std::size_t>(resolution_ - first_row));
  }

 private:
  void add_corner(const Vector3d& seen, std::uint32_t label) {
    corners_.push_back({{static_cast<float>(seen.x), static_cast<float>(seen.y), static_cast<float>(seen.z)}, label});
  }

  void make_target() {
    GLuint frame = 0, buffer[2] = {0, 0};
    gl_.GenFramebuffers(1, &frame);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl_.GenRenderbuffers(2, buffer);
    const GLenum formats[2] = {GL_R32UI, GL_DEPTH_COMPONENT32F};
    const GLenum places[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (const int k : {0, 1}) {
      gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer[k]);
      gl_.RenderbufferStorage(GL_RENDERBUFFER, formats[k], resolution_, resolution_);
      gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, places[k], GL_RENDERBUFFER, buffer[k]);
    }
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) refuse("no target of whole numbers");
  }

  void make_program() {
    const GLuint program = gl_.CreateProgram();
    const auto add = [&](GLenum kind, const char* text) {
      const GLuint shader = gl_.CreateShader(kind);
      gl_.ShaderSource(shader, 1, &text, nullptr);
      gl_.CompileShader(shader);
      gl_.AttachShader(program, shader);
    };
    add(GL_VERTEX_SHADER, kVertexShader);
    add(GL_FRAGMENT_SHADER, kFragmentShader);
    gl_.LinkProgram(program);
    GLint is_linked = 0;
    gl_.GetProgramiv(program, GL_LINK_STATUS, &is_linked);
    if (is_linked == 0) refuse("its shaders do not compile");
    gl_.UseProgram(program);
    nearest_ = gl_.GetUniformLocation(program, "nearest");
  }

  void make_corners() {
    GLuint array = 0, buffer = 0;
    gl_.GenVertexArrays(1, &array);
    gl_.BindVertexArray(array);
    gl_.GenBuffers(1, &buffer);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl_.EnableVertexAttribArray(0);
    gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Corner), nullptr);
    gl_.EnableVertexAttribArray(1);
    gl_.VertexAttribIPointer(1, 1, GL_UNSIGNED_INT, sizeof(Corner), reinterpret_cast<const void*>(sizeof(float[3])));
  }

  void require_no_error() const {
    if (gl_.GetError() != GL_NO_ERROR) refuse("it reports an error");
  }

  GlContext context_;
  OpenGl gl_;
  GLsizei resolution_;
  GLint nearest_ = -1;
  std::vector<std::uint32_t> label_;
  std::vector<Corner> corners_;
};

}  // namespace

std::unique_ptr<ItemBuffer3> gl_item_buffer_3(std::uint32_t resolution) {
  return std::make_unique<GlItemBuffer3>(resolution);
}

}  // namespace hottel
