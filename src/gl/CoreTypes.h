#pragma once

/// GL's types, constants and function pointers, without windows.h, which glcorearb.h would include
/// for APIENTRY alone and whose macros (near, far, min, max ...) are names of ours.
#if defined(_WIN32) && !defined(APIENTRY)
#define APIENTRY __stdcall
#endif

#include <GL/glcorearb.h>
