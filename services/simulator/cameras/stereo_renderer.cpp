#include "services/simulator/cameras/stereo_renderer.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <mujoco/mujoco.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "services/simulator/cameras/camera_mjcf.hpp"
#include "services/simulator/model/physics.hpp"

namespace markservo::simulator {
namespace {

constexpr int kMaxDrawnGeoms = 500;

[[noreturn]] void fail(const std::string& step) {
  throw std::runtime_error("EGL: " + step + " failed, error " + std::to_string(eglGetError()) +
                           "; Debian packages needed: libegl1 libgl1-mesa-dri");
}

EGLDisplay surfaceless_display() {
  const auto get_platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_platform_display == nullptr) fail("eglGetPlatformDisplayEXT");
  const EGLDisplay display = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) fail("a display without surfaces");
  return display;
}

}  // namespace

struct StereoRenderer::Context {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext egl = EGL_NO_CONTEXT;
  std::uint64_t loaded_world = 0;  // 0: none
  mjrContext gl;
  mjvScene scene;
  mjvOption option;

  Context() {
    mjr_defaultContext(&gl);
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    display = surfaceless_display();
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE) fail("eglInitialize");
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &count) != EGL_TRUE || count < 1) fail("eglChooseConfig");
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) fail("eglBindAPI");
    egl = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (egl == EGL_NO_CONTEXT) fail("eglCreateContext");
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl) != EGL_TRUE) fail("eglMakeCurrent");
  }

  ~Context() {
    unload();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, egl);
    eglTerminate(display);
  }

  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void unload() {
    if (loaded_world == 0) return;
    mjr_freeContext(&gl);
    mjv_freeScene(&scene);
    loaded_world = 0;
  }

  void load(const Physics& world) {
    unload();
    mjv_makeScene(world.model(), &scene, kMaxDrawnGeoms);
    mjr_makeContext(world.model(), &gl, mjFONTSCALE_100);
    loaded_world = world.id();
    mjr_setBuffer(mjFB_OFFSCREEN, &gl);
    if (gl.currentBuffer != mjFB_OFFSCREEN) throw std::runtime_error("OpenGL: no offscreen buffer");
    for (const int effect : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_HAZE}) scene.flags[effect] = 0;
  }

  cv::Mat draw(const Physics& world, const char* camera_name) {
    mjvCamera camera;
    mjv_defaultCamera(&camera);
    camera.type = mjCAMERA_FIXED;
    camera.fixedcamid = mj_name2id(world.model(), mjOBJ_CAMERA, camera_name);
    mjv_updateCamera(world.model(), world.data(), &camera, &scene);
    const mjrRect viewport = {0, 0, gl.offWidth, gl.offHeight};
    mjr_render(viewport, &scene, &gl);
    cv::Mat image(viewport.height, viewport.width, CV_8UC3);
    mjr_readPixels(image.data, nullptr, viewport, &gl);
    // OpenGL's rows go up, its colours start with red.
    cv::flip(image, image, 0);
    cv::cvtColor(image, image, cv::COLOR_RGB2BGR);
    return image;
  }
};

StereoRenderer::StereoRenderer() : context_(std::make_unique<Context>()) {}
StereoRenderer::~StereoRenderer() = default;

ImagePair StereoRenderer::render(const Physics& world) {
  if (context_->loaded_world != world.id()) context_->load(world);
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  mjv_updateScene(world.model(), world.data(), &context_->option, nullptr, &camera, mjCAT_ALL, &context_->scene);
  return {context_->draw(world, kLeftCamera), context_->draw(world, kRightCamera)};
}

}  // namespace markservo::simulator
