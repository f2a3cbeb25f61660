#pragma once

#include <array>
#include <cstddef>

#include <aolib/Status.h>

#include "backbone/cubemaps/TileTable.h"
#include "backbone/frame/FrameBudget.h"
#include "gl/GLSLShader.h"

namespace aolib {

/// What an estimator reads of a cube map's surroundings, captured in units of work between which a
/// frame may end.
class AbstractCapture {
public:
    AbstractCapture() = default;
    virtual ~AbstractCapture() = default;
    AbstractCapture(const AbstractCapture&) = delete;
    AbstractCapture& operator=(const AbstractCapture&) = delete;

    virtual bool complete() const = 0;
    /// Returns the kind of the next unit; only while the capture is not complete.
    virtual WorkUnit next() const = 0;
    /// Whether the next unit needs a GPU result that is not available yet: step() then waits.
    virtual bool waits() const { return false; }
    /// Computes the next unit. Errors: MissingCapability, OutOfMemory.
    virtual AoStatus step() = 0;

    /// Makes a complete capture readable and sets the uniforms of its view.
    virtual void bind(gl::GLSLShader& shader) const = 0;
    /// The faces that hold geometry.
    virtual std::array<bool, kFaces> modelled() const = 0;
    /// Surfaces or solid intervals along a ray of one face, at most.
    virtual int layersOf(int face) const {
        return modelled()[static_cast<std::size_t>(face)] ? 1 : 0;
    }
    /// Maximum number of surfaces or solid intervals along a ray of any face.
    virtual int layers() const = 0;
    /// GPU memory, bytes: at present, and the maximum so far.
    virtual std::size_t bytes() const = 0;
    virtual std::size_t mostBytes() const { return bytes(); }
};

} // namespace aolib
