// Compiles and links a vertex and a fragment shader (GLSL ES 3.00) with whatever driver of OpenGL ES is found. What the
// driver has to say of its code, as messages of KHR_debug, goes to standard output; what INTEL_DEBUG or AMD_DEBUG list, to standard error.
//
//   printCode [shader.vert shader.frag]      names the driver, where no shaders are given
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <GLES2/gl2ext.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static void fail(const char *what, const char *log) {
  printf("FAILED %s\n%s\n", what, log);
  fflush(stdout);
  _exit(1);
}

static void onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar *text, const void *user) {
  (void)source, (void)type, (void)id, (void)severity, (void)user;
  printf("%.*s\n", (int)length, text);
}

static GLuint compile(GLenum stage, const char *path) {
  FILE *file = fopen(path, "rb");
  if (!file) fail(path, "cannot be read");
  fseek(file, 0, SEEK_END);
  long size = ftell(file);
  rewind(file);
  char *text = calloc(1, size + 1);
  if (fread(text, 1, size, file) != (size_t)size) fail(path, "cannot be read");
  fclose(file);
  GLuint shader = glCreateShader(stage);
  const char *source = text;
  glShaderSource(shader, 1, &source, NULL);
  glCompileShader(shader);
  free(text);
  GLint isCompiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
  char log[8192] = "";
  glGetShaderInfoLog(shader, sizeof log, NULL, log);
  if (!isCompiled) fail(path, log);
  return shader;
}

int main(int count, char **arguments) {
  PFNEGLGETPLATFORMDISPLAYEXTPROC getDisplay = (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
  EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL);
  if (!eglInitialize(display, NULL, NULL)) fail("eglInitialize", "");
  eglBindAPI(EGL_OPENGL_ES_API);
  const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE};
  EGLConfig config;
  EGLint found = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &found) || !found) fail("eglChooseConfig", "");
  const EGLint ofContext[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, ofContext);
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) fail("eglMakeCurrent", "");
  printf("DRIVER %s, %s\n", glGetString(GL_RENDERER), glGetString(GL_VERSION));
  if (count < 3) {
    fflush(stdout);
    _exit(0);
  }

  PFNGLDEBUGMESSAGECALLBACKKHRPROC setCallback = (PFNGLDEBUGMESSAGECALLBACKKHRPROC)eglGetProcAddress("glDebugMessageCallbackKHR");
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR);
  glEnable(GL_DEBUG_OUTPUT_KHR);
  setCallback(onMessage, NULL);
  GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER, arguments[1]));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, arguments[2]));
  // As three.js does.
  glBindAttribLocation(program, 0, "position");
  glLinkProgram(program);
  GLint isLinked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &isLinked);
  char log[8192] = "";
  glGetProgramInfoLog(program, sizeof log, NULL, log);
  if (!isLinked) fail("link", log);

  // Some drivers compile on threads of their own, and a frame waits for them.
  GLuint target, frame;
  glGenTextures(1, &target);
  glBindTexture(GL_TEXTURE_2D, target);
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 64, 64);
  glGenFramebuffers(1, &frame);
  glBindFramebuffer(GL_FRAMEBUFFER, frame);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
  glUseProgram(program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFlush();
  printf("DONE\n");
  fflush(stdout);
  // There is no device whose things could be put away.
  _exit(0);
}
