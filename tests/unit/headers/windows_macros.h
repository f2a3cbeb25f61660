// The macros of Microsoft's windows.h that are words of C++ programs, as it defines them.
#pragma once
#define near
#define far
#define NEAR near
#define FAR far
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define ERROR 0
#define NO_ERROR 0L
#define DELETE (0x00010000L)
#define STRICT 1
#define OPAQUE 2
#define TRANSPARENT 1
#define ABSOLUTE 1
#define RELATIVE 2
#define DIFFERENCE 11
#define TRUE 1
#define FALSE 0
#define small char
#define hyper __int64
#define interface struct
#define cdecl __cdecl
#define pascal __stdcall
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define GetObject GetObjectA
#define GetMessage GetMessageA
#define CreateWindow CreateWindowA
#define DrawText DrawTextA
#define LoadImage LoadImageA
#define SendMessage SendMessageA
