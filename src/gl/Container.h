#pragma once

#include <functional>
#include <memory>
#include <string>

#include <aolib/Status.h>

#include "gl/ContextGroup.h"

namespace aolib::gl {

/// A GL object that contexts do not share (a framebuffer, a vertex array, a query): one in each
/// context of a group that work is done in, all alike. Move-only.
class Container {
public:
    /// What GL calls such objects, and how it makes and deletes them.
    struct Kind {
        const char* name;
        PFNGLGENFRAMEBUFFERSPROC Functions::*generate;
        PFNGLDELETEFRAMEBUFFERSPROC Functions::*remove;
    };
    static constexpr Kind kFramebuffer{"framebuffer", &Functions::GenFramebuffers,
                                       &Functions::DeleteFramebuffers};
    static constexpr Kind kVertexArray{"vertex array", &Functions::GenVertexArrays,
                                       &Functions::DeleteVertexArrays};
    static constexpr Kind kQuery{"query", &Functions::GenQueries, &Functions::DeleteQueries};

    /// Gives a new object its content, on a known GL state of GL state. It must hold what it needs
    /// by value: it is called again in other contexts.
    using Fill = std::function<AoStatus(const Functions& gl, GLuint name)>;

    Container() = default;
    /// Makes it in the current context. Errors: OutOfMemory, those of `fill`.
    static Result<Container> create(const Functions& gl, const Kind& kind, const std::string& label,
                                    Fill fill = {});

    /// Its name in the current context.
    GLuint name() const;
    explicit operator bool() const { return content_ != nullptr; }

private:
    struct Content;
    struct Deleter {
        void operator()(Content* content) const;
    };
    std::unique_ptr<Content, Deleter> content_; ///< stays where it is: the group refers to it
};

} // namespace aolib::gl
