#pragma once

/// Includes all headers of the core library: `#include <aolib/aolib.h>`.
#include <aolib/AmbientOcclusion.h>
#include <aolib/HostTextures.h>
#include <aolib/OptionFields.h>
#include <aolib/Options.h>
#include <aolib/ProcAddressLoader.h>
#include <aolib/Scene.h>
#include <aolib/SceneRenderer.h>
#include <aolib/Statistics.h>
#include <aolib/Status.h>
#include <aolib/ViewId.h>
