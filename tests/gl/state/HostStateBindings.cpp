// What is bound where, and what runs.
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "HostState.h"

#define AOLIB_NAMED(name) #name, name

namespace aolib {

void HostState::recordTextureUnits(StateRecorder& to) const {
    const GLint active = gl_.integer(GL_ACTIVE_TEXTURE);
    to.value("GL_ACTIVE_TEXTURE", active);
    std::vector<std::pair<const char*, GLenum>> bindings{
        {AOLIB_NAMED(GL_TEXTURE_BINDING_1D)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_2D)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_3D)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_1D_ARRAY)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_2D_ARRAY)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_RECTANGLE)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_BUFFER)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_CUBE_MAP)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE)},
        {AOLIB_NAMED(GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY)},
        {AOLIB_NAMED(GL_SAMPLER_BINDING)}};
    if (gl_.has.cubeMapArray) {
        bindings.emplace_back(AOLIB_NAMED(GL_TEXTURE_BINDING_CUBE_MAP_ARRAY));
    }
    for (int unit = 0; unit < gl_.has.textureUnits; ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const auto& [name, query] : bindings) {
            to.value(name, static_cast<std::size_t>(unit), gl_.integer(query));
        }
    }
    gl_.ActiveTexture(static_cast<GLenum>(active));
    if (!gl_.has.imageUnits) {
        return;
    }
    for (int unit = 0; unit < gl_.integer(GL_MAX_IMAGE_UNITS); ++unit) {
        for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(GL_IMAGE_BINDING_NAME)},
                                                      {AOLIB_NAMED(GL_IMAGE_BINDING_LEVEL)},
                                                      {AOLIB_NAMED(GL_IMAGE_BINDING_ACCESS)},
                                                      {AOLIB_NAMED(GL_IMAGE_BINDING_FORMAT)}}) {
            GLint value = 0;
            gl_.GetIntegeri_v(query, static_cast<GLuint>(unit), &value);
            to.value(name, static_cast<std::size_t>(unit), value);
        }
    }
}

void HostState::recordBuffers(StateRecorder& to) const {
    const auto bound = [&](const char* name, GLenum query) { to.value(name, gl_.integer(query)); };
    bound(AOLIB_NAMED(GL_ARRAY_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_COPY_READ_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_COPY_WRITE_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_PIXEL_PACK_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_PIXEL_UNPACK_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_TEXTURE_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_UNIFORM_BUFFER_BINDING));
    bound(AOLIB_NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING));
    if (gl_.has.indirect) {
        bound(AOLIB_NAMED(GL_DRAW_INDIRECT_BUFFER_BINDING));
    }
    if (gl_.has.compute) {
        bound(AOLIB_NAMED(GL_DISPATCH_INDIRECT_BUFFER_BINDING));
    }
    if (gl_.has.queryBuffer) {
        bound(AOLIB_NAMED(GL_QUERY_BUFFER_BINDING));
    }
    if (gl_.has.parameterBuffer) {
        bound(AOLIB_NAMED(GL_PARAMETER_BUFFER_BINDING));
    }
    const auto indexed = [&](const char* name, GLenum binding, GLenum start, GLenum size,
                             GLenum limit) {
        bound(name, binding);
        for (int i = 0; i < gl_.integer(limit); ++i) {
            GLint buffer = 0;
            std::array<GLint64, 2> part{};
            gl_.GetIntegeri_v(binding, static_cast<GLuint>(i), &buffer);
            gl_.GetInteger64i_v(start, static_cast<GLuint>(i), part.data());
            gl_.GetInteger64i_v(size, static_cast<GLuint>(i), part.data() + 1);
            to.value(name, static_cast<std::size_t>(i), buffer);
            to.values(name, static_cast<std::size_t>(i), part.data(), 2);
        }
    };
    indexed(AOLIB_NAMED(GL_UNIFORM_BUFFER_BINDING), GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE,
            GL_MAX_UNIFORM_BUFFER_BINDINGS);
    indexed(AOLIB_NAMED(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING), GL_TRANSFORM_FEEDBACK_BUFFER_START,
            GL_TRANSFORM_FEEDBACK_BUFFER_SIZE, GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS);
    if (gl_.has.atomicCounters) {
        indexed(AOLIB_NAMED(GL_ATOMIC_COUNTER_BUFFER_BINDING), GL_ATOMIC_COUNTER_BUFFER_START,
                GL_ATOMIC_COUNTER_BUFFER_SIZE, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS);
    }
    if (gl_.has.shaderStorage) {
        indexed(AOLIB_NAMED(GL_SHADER_STORAGE_BUFFER_BINDING), GL_SHADER_STORAGE_BUFFER_START,
                GL_SHADER_STORAGE_BUFFER_SIZE, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    }
}

void HostState::recordVertexArray(StateRecorder& to) const {
    to.value("GL_VERTEX_ARRAY_BINDING", gl_.integer(GL_VERTEX_ARRAY_BINDING));
    to.value("GL_ELEMENT_ARRAY_BUFFER_BINDING", gl_.integer(GL_ELEMENT_ARRAY_BUFFER_BINDING));
    for (std::size_t i = 0; i < static_cast<std::size_t>(gl_.has.attributes); ++i) {
        const auto index = static_cast<GLuint>(i);
        for (const auto& [name, query] :
             NamedQueries{{AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_ENABLED)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_SIZE)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_STRIDE)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_TYPE)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_NORMALIZED)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_INTEGER)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_DIVISOR)},
                          {AOLIB_NAMED(GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING)}}) {
            GLint value = 0;
            gl_.GetVertexAttribiv(index, query, &value);
            to.value(name, i, value);
        }
        void* pointer = nullptr;
        gl_.GetVertexAttribPointerv(index, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
        to.value("GL_VERTEX_ATTRIB_ARRAY_POINTER", i,
                 static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer)));
        // A compatibility context has no current value for attribute 0.
        if (i > 0 || !gl_.has.compatibility) {
            std::array<GLfloat, 4> current{};
            gl_.GetVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, current.data());
            to.values("GL_CURRENT_VERTEX_ATTRIB", i, current.data(), 4);
        }
    }
}

void HostState::recordFramebuffers(StateRecorder& to) const {
    const GLint draw = gl_.integer(GL_DRAW_FRAMEBUFFER_BINDING);
    const GLint read = gl_.integer(GL_READ_FRAMEBUFFER_BINDING);
    to.value("GL_DRAW_FRAMEBUFFER_BINDING", draw);
    to.value("GL_READ_FRAMEBUFFER_BINDING", read);
    to.value("GL_RENDERBUFFER_BINDING", gl_.integer(GL_RENDERBUFFER_BINDING));
    for (std::size_t i = 0; i < static_cast<std::size_t>(gl_.has.drawBuffers); ++i) {
        to.value("GL_DRAW_BUFFER", i, gl_.integer(GL_DRAW_BUFFER0 + static_cast<GLenum>(i)));
    }
    to.value("GL_READ_BUFFER", gl_.integer(GL_READ_BUFFER));
    const std::array<std::pair<const char*, GLenum>, 5> attachments{
        {{AOLIB_NAMED(GL_COLOR_ATTACHMENT0)},
         {AOLIB_NAMED(GL_COLOR_ATTACHMENT1)},
         {AOLIB_NAMED(GL_COLOR_ATTACHMENT2)},
         {AOLIB_NAMED(GL_DEPTH_ATTACHMENT)},
         {AOLIB_NAMED(GL_STENCIL_ATTACHMENT)}}};
    const auto attached = [&](GLenum target, std::size_t which, GLint bound) {
        for (const auto& [name, attachment] : attachments) {
            std::array<GLint, 3> found{};
            if (bound != 0) {
                gl_.GetFramebufferAttachmentParameteriv(
                    target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, found.data());
            }
            if (found[0] != GL_NONE) {
                gl_.GetFramebufferAttachmentParameteriv(
                    target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, found.data() + 1);
            }
            if (found[0] == GL_TEXTURE) {
                gl_.GetFramebufferAttachmentParameteriv(
                    target, attachment, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, found.data() + 2);
            }
            to.values(name, which, found.data(), 3);
        }
    };
    attached(GL_DRAW_FRAMEBUFFER, 0, draw);
    attached(GL_READ_FRAMEBUFFER, 1, read);
}

void HostState::recordRunning(StateRecorder& to) const {
    to.value("GL_CURRENT_PROGRAM", gl_.integer(GL_CURRENT_PROGRAM));
    if (gl_.has.separatePrograms) {
        to.value("GL_PROGRAM_PIPELINE_BINDING", gl_.integer(GL_PROGRAM_PIPELINE_BINDING));
    }
    if (gl_.has.transformFeedback2) {
        integers(to, AOLIB_NAMED(GL_TRANSFORM_FEEDBACK_BINDING));
        integers(to, AOLIB_NAMED(GL_TRANSFORM_FEEDBACK_ACTIVE));
        integers(to, AOLIB_NAMED(GL_TRANSFORM_FEEDBACK_PAUSED));
    }
    for (const auto& [target, name] : objects_.queries) {
        GLint current = 0;
        gl_.GetQueryiv(target, GL_CURRENT_QUERY, &current);
        to.value("GL_CURRENT_QUERY", target, current);
    }
    if (gl_.has.debug) {
        integers(to, AOLIB_NAMED(GL_DEBUG_GROUP_STACK_DEPTH));
        for (const auto& [name, query] :
             NamedQueries{{AOLIB_NAMED(GL_DEBUG_CALLBACK_FUNCTION)},
                          {AOLIB_NAMED(GL_DEBUG_CALLBACK_USER_PARAM)}}) {
            void* pointer = nullptr;
            gl_.GetPointerv(query, &pointer);
            to.value(name, static_cast<double>(reinterpret_cast<std::uintptr_t>(pointer)));
        }
    }
}

void HostState::recordObjects(StateRecorder& to) const {
    // Parameters of the textures that sit where aolib binds its own, and of the samplers.
    const GLint bound = gl_.integer(GL_TEXTURE_BINDING_2D);
    for (const GLuint name : objects_.textures.at(GL_TEXTURE_2D)) {
        gl_.BindTexture(GL_TEXTURE_2D, name);
        for (const auto& [parameter, query] : NamedQueries{{AOLIB_NAMED(GL_TEXTURE_MIN_FILTER)},
                                                           {AOLIB_NAMED(GL_TEXTURE_MAG_FILTER)},
                                                           {AOLIB_NAMED(GL_TEXTURE_WRAP_S)},
                                                           {AOLIB_NAMED(GL_TEXTURE_WRAP_T)},
                                                           {AOLIB_NAMED(GL_TEXTURE_MAX_LEVEL)}}) {
            GLfloat value = 0.0F;
            gl_.GetTexParameterfv(GL_TEXTURE_2D, query, &value);
            to.value("texture", name, parameter, static_cast<double>(value));
        }
        GLint width = 0;
        gl_.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        to.value("texture", name, "GL_TEXTURE_WIDTH", width);
    }
    gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(bound));
    for (const GLuint name : {objects_.program, objects_.feedbackProgram}) {
        std::array<GLfloat, 4> colour{};
        gl_.GetUniformfv(name, gl_.GetUniformLocation(name, "colour"), colour.data());
        to.values("uniform", name, colour.data(), 4);
    }
    for (const GLuint name : objects_.samplers) {
        GLfloat value = 0.0F;
        gl_.GetSamplerParameterfv(name, GL_TEXTURE_MIN_FILTER, &value);
        to.value("sampler", name, "GL_TEXTURE_MIN_FILTER", static_cast<double>(value));
    }
}

} // namespace aolib

#undef AOLIB_NAMED
