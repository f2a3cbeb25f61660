#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "HostGl.h"

namespace aolib {

/// Kinds of framebuffers that a host may draw to; all but the default one are kWidth x kHeight.
enum class HostTarget {
    Plain,        ///< RGBA8, 24 bit depth with stencil
    Srgb,         ///< SRGB8_ALPHA8, 24 bit depth with stencil
    Multisampled, ///< RGBA8, 24 bit depth with stencil, 4 samples
    ManyColours,  ///< three colour textures, float depth
    FloatColour,  ///< RGBA16F, float depth with stencil
    ColourOnly,   ///< no depth: aolib must refuse it
    Incomplete,   ///< nothing attached: aolib must refuse it
    Default,      ///< framebuffer 0, which a context without a surface does not have
};
inline constexpr std::size_t kHostTargets = 8;

/// Everything that a host may have bound: real objects of every kind, owned.
class HostObjects {
public:
    static constexpr int kWidth = 32;
    static constexpr int kHeight = 18;
    static constexpr int kColours = 3; ///< of HostTarget::ManyColours
    static constexpr int kBufferBytes = 4096;

    explicit HostObjects(const HostGl& gl);
    ~HostObjects();
    HostObjects(const HostObjects&) = delete;
    HostObjects& operator=(const HostObjects&) = delete;

    GLuint framebuffer(HostTarget target) const {
        return framebuffers_[static_cast<std::size_t>(target)];
    }
    /// Whether it can be drawn to, and has depth.
    bool usable(HostTarget target) const;
    /// The buffers and textures whose content is not what it was; empty if all are intact. In a
    /// calm state only, which it leaves.
    std::string damage() const;

    std::map<GLenum, std::vector<GLuint>> textures; ///< by target, complete
    std::vector<GLuint> samplers;
    std::vector<GLuint> buffers;         ///< with data of their own
    std::vector<GLuint> feedbackBuffers; ///< with data, for transform feedback only
    std::vector<GLuint> vertexArrays;    ///< with enabled attributes and an element buffer
    std::vector<GLuint> renderbuffers;
    std::vector<GLuint> feedbacks;    ///< transform feedback objects, where the context knows them
    std::vector<GLuint> pipelines;    ///< program pipelines, where the context knows them
    GLuint program = 0;               ///< draws nothing of use
    GLuint feedbackProgram = 0;       ///< has a varying to capture
    GLuint fragmentProgram = 0;       ///< separable, in the pipelines
    std::map<GLenum, GLuint> queries; ///< by target
    GLuint emptyQuery = 0;            ///< ended: no sample passed

private:
    void makeTextures();
    void makeSamplers();
    void makeBuffers();
    void makeVertexArrays();
    void makePrograms();
    void makeQueries();
    void makeFramebuffers();
    GLuint colourTexture(GLenum format, GLenum type);
    GLuint renderbuffer(GLenum format, int samples);
    void makeFramebuffer(HostTarget target, const std::vector<GLuint>& colours, GLuint depth,
                         bool stencil);

    const HostGl& gl_;
    std::array<GLuint, kHostTargets> framebuffers_{};
    std::vector<GLuint> ownTextures_; ///< of framebuffers
};

} // namespace aolib
