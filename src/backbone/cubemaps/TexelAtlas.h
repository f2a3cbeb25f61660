#pragma once

#include "backbone/cubemaps/FaceStore.h"
#include "backbone/cubemaps/PageStore.h"

namespace aolib {

/// The texels of all cube maps: their faces, and the pages of tiles beside them.
struct TexelAtlas {
    explicit TexelAtlas(const gl::Functions& gl) : faces(gl), pages(faces) {}
    TexelAtlas(const TexelAtlas&) = delete;
    TexelAtlas& operator=(const TexelAtlas&) = delete;

    FaceStore faces;
    PageStore pages;
};

} // namespace aolib
