// SDL, loaded when a window opens.
#pragma once

#define SDL_MAIN_HANDLED
#include <SDL.h>

namespace hottel {

// Functions of SDL, SDL_CreateTexture as CreateTexture.
// clang-format off
#define HOTTEL_EACH_OF_SDL(each) \
  each(CreateRenderer) each(CreateTexture) each(CreateWindow) each(DestroyRenderer) each(DestroyTexture) \
  each(DestroyWindow) each(GetCurrentVideoDriver) each(GetError) each(GetRendererOutputSize) each(GetVersion) \
  each(GetWindowSize) each(InitSubSystem) each(LoadFunction) each(LoadObject) each(PeepEvents) each(PumpEvents) \
  each(PushEvent) each(Quit) each(RegisterEvents) each(RenderCopy) each(RenderPresent) each(SetClipboardText) \
  each(SetHint) each(SetHintWithPriority) each(SetMainReady) each(SetTextureBlendMode) each(SetWindowTitle) \
  each(StartTextInput) each(StopTextInput) each(UpdateTexture) each(WaitEventTimeout) each(WasInit)
// clang-format on

struct Sdl {
#define HOTTEL_MEMBER(name) decltype(&SDL_##name) name;
  HOTTEL_EACH_OF_SDL(HOTTEL_MEMBER)
#undef HOTTEL_MEMBER
};

// Returns SDL's functions; the first call loads its library. No program is linked with it, for it brings some forty
// libraries, which would take half of the start of commands that open no window, and which machines without a screen
// need not have.
//
// Throws RequestError where there is no SDL 2.0.18 or later on this machine: what() says what needs no window.
const Sdl& sdl();

}  // namespace hottel
