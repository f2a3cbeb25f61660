#pragma once

#include "HostKinds.h"
#include "gl/GLSLShader.h"
#include "gl/VertexArray.h"

namespace aolib::test {

/// A host that draws everything in one colour: then its picture is that colour times W.
class WhiteHost {
public:
    /// @param gl  must outlive it.
    WhiteHost(const gl::Functions& gl, const Model& model);
    void draw(const CameraKind& camera, float white);

private:
    const gl::Functions& gl_;
    gl::VertexArray vertices_;
    gl::GLSLShader shader_;
};

} // namespace aolib::test
