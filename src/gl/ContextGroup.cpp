#include "gl/ContextGroup.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <limits>
#include <string_view>
#include <utility>

namespace aolib::gl {

namespace {

/// A context of the group in which nothing was made: objects that are shared can be deleted.
constexpr ContextId kVisited = std::numeric_limits<ContextId>::max();

/// A text that no other group marks its contexts with, be it of another copy of this library.
std::string uniqueText() {
    static std::atomic<unsigned> counter{0};
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "aolib context group %p.%u",
                  static_cast<const void*>(&counter), ++counter);
    return text.data();
}

/// Puts back the two bindings that recognising and marking a context need, unless they are trusted.
class VertexBindings {
public:
    explicit VertexBindings(const Functions& gl) : gl_(gl) {
        if (!gl_.trusted.programs) {
            gl_.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &array_);
        }
    }
    ~VertexBindings() {
        if (array_ >= 0) {
            gl_.BindVertexArray(static_cast<GLuint>(array_));
        }
        if (buffer_ >= 0) {
            gl_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
        }
    }
    VertexBindings(const VertexBindings&) = delete;
    VertexBindings& operator=(const VertexBindings&) = delete;

    void alsoBuffer() {
        if (!gl_.trusted.programs) {
            gl_.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &buffer_);
        }
    }

private:
    const Functions& gl_;
    GLint array_ = -1; ///< none was saved
    GLint buffer_ = -1;
};

} // namespace

ContextGroup::ContextGroup(Functions& gl) : gl_(gl), text_(uniqueText()) {}

ContextGroup::~ContextGroup() {
    enterToDelete();
    if (current_ == 0) {
        return;
    }
    for (const Member& member : members_) {
        if (member.id == current_) {
            gl_.DeleteVertexArrays(1, &member.marker);
        }
        gl_.DeleteBuffers(1, &member.buffer);
    }
    gl_.DeleteShader(marker_);
}

AoStatus ContextGroup::found() {
    marker_ = gl_.CreateShader(GL_VERTEX_SHADER);
    if (marker_ == 0) {
        return {StatusCode::OutOfMemory, "aolib/contexts: GL gave no shader name"};
    }
    const GLchar* text = text_.c_str();
    gl_.ShaderSource(marker_, 1, &text, nullptr);
    VertexBindings bindings(gl_);
    bindings.alsoBuffer();
    return addCurrent().status();
}

AoStatus ContextGroup::check() const {
    if (gone_) {
        return {StatusCode::NoContext,
                "abandon() was called: this instance has no context; create another instance"};
    }
    if (gl_.GetString(GL_VERSION) == nullptr) {
        return {StatusCode::NoContext, "no OpenGL context is current in this thread"};
    }
    std::array<GLchar, 64> text{};
    GLsizei length = 0;
    if (gl_.IsShader(marker_) == GL_TRUE) {
        gl_.GetShaderSource(marker_, static_cast<GLsizei>(text.size()), &length, text.data());
    }
    if (std::string_view(text.data(), static_cast<std::size_t>(length)) != text_) {
        return {StatusCode::WrongContext,
                "the current OpenGL context shares no objects with the one that was current at "
                "create(); make the context of create() current, or one that shares its objects"};
    }
    return {};
}

AoStatus ContextGroup::enter() {
    current_ = 0;
    if (AoStatus status = check(); !status) {
        return status;
    }
    VertexBindings bindings(gl_);
    const Member* member = find();
    if (member == nullptr) {
        bindings.alsoBuffer();
        const Result<const Member*> added = addCurrent();
        if (!added) {
            return added.status();
        }
        member = *added;
    }
    become(*member);
    return {};
}

bool ContextGroup::ownsCurrent(const Member& member) const {
    if (gl_.IsVertexArray(member.marker) == GL_FALSE) {
        return false;
    }
    GLint source = 0;
    gl_.BindVertexArray(member.marker);
    gl_.GetVertexAttribiv(0, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &source);
    return static_cast<GLuint>(source) == member.buffer;
}

const ContextGroup::Member* ContextGroup::find() const {
    const auto is = [this](const Member& member) { return ownsCurrent(member); };
    if (latest_ != 0 && is(members_[latest_ - 1])) {
        return &members_[latest_ - 1];
    }
    const auto found = std::find_if(members_.begin(), members_.end(), is);
    return found != members_.end() ? &*found : nullptr;
}

Result<const ContextGroup::Member*> ContextGroup::addCurrent() {
    Member member{.id = static_cast<ContextId>(members_.size() + 1), .capabilities = {}};
    if (!members_.empty()) { // of another version or profile, maybe
        if (AoStatus status = gl_.readCapabilities(); !status) {
            gl_.capabilities = members_[latest_ - 1].capabilities;
            return status;
        }
    }
    member.capabilities = gl_.capabilities;
    gl_.GenVertexArrays(1, &member.marker);
    gl_.GenBuffers(1, &member.buffer);
    if (member.marker == 0 || member.buffer == 0) {
        gl_.DeleteVertexArrays(1, &member.marker);
        gl_.DeleteBuffers(1, &member.buffer);
        return AoStatus(StatusCode::OutOfMemory,
                        "aolib/contexts: GL gave no vertex array name or no buffer name");
    }
    gl_.BindVertexArray(member.marker);
    gl_.BindBuffer(GL_ARRAY_BUFFER, member.buffer);
    gl_.VertexAttribPointer(0, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
    members_.push_back(member);
    return &members_.back();
}

void ContextGroup::become(const Member& member) {
    current_ = member.id;
    behind_ = behind_ || (latest_ != 0 && latest_ != current_);
    latest_ = current_;
    gl_.capabilities = member.capabilities;
    deleteWaiting();
}

AoStatus ContextGroup::makeContainers() {
    if (!behind_) {
        return {};
    }
    for (const MakeHere* make : containers_) {
        if (AoStatus status = (*make)(); !status) {
            return status;
        }
    }
    behind_ = false;
    return {};
}

void ContextGroup::enterToDelete() {
    current_ = 0;
    if (!check()) {
        return;
    }
    const VertexBindings bindings(gl_);
    const Member* member = find();
    current_ = member != nullptr ? member->id : kVisited;
    deleteWaiting();
}

AoStatus ContextGroup::confirm() {
    const ContextId entered = std::exchange(current_, 0);
    if (AoStatus status = check(); !status) {
        return status;
    }
    const VertexBindings bindings(gl_);
    if (entered == 0 || !ownsCurrent(members_[entered - 1])) {
        return {StatusCode::WrongContext,
                "another OpenGL context is current after a callback; make the original context "
                "current before the callback returns"};
    }
    current_ = entered;
    return {};
}

void ContextGroup::leave(ContextId outer) {
    current_ = gone_ ? 0 : outer;
}

void ContextGroup::abandon() {
    gone_ = true;
    current_ = 0;
    members_.clear();
    waiting_.clear();
}

void ContextGroup::release(ContextId owner, std::function<void()> deletion) {
    if (current_ != 0 && (owner == 0 || owner == current_)) {
        deletion();
    } else if (!gone_) {
        waiting_.push_back({owner, std::move(deletion)});
    }
}

void ContextGroup::deleteWaiting() {
    std::erase_if(waiting_, [this](const Waiting& waiting) {
        const bool here = waiting.owner == 0 || waiting.owner == current_;
        if (here) {
            waiting.deletion();
        }
        return here;
    });
}

ContextId currentContext(const Functions& gl) {
    return gl.group != nullptr ? gl.group->current() : 0;
}

void release(const Functions& gl, ContextId owner, std::function<void()> deletion) {
    if (gl.group != nullptr) {
        gl.group->release(owner, std::move(deletion));
    } else {
        deletion();
    }
}

} // namespace aolib::gl
