#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <aolib/Status.h>

#include "gl/Functions.h"

namespace aolib::gl {

/// One context of a group, by the order in which they were first met; 0 is none of them.
using ContextId = std::uint32_t;

/// The contexts that share objects with the one that an instance was made in, and which of them is
/// current. GL shares textures, buffers, programs and fences between them; framebuffers, vertex
/// arrays and queries ("containers") exist once in each.
///
/// A context is recognised by objects that only it can have: the group by a shader with a text of
/// its own, a context by a vertex array that a buffer of its own is attached to. Asking raises no
/// error in, and changes nothing of, a context outside the group.
///
/// Names of objects are never deleted elsewhere: what is released while no context, or another one,
/// is current waits until its own is.
class ContextGroup {
public:
    /// @param gl  the table of the instance; its capabilities follow the context that is current.
    explicit ContextGroup(Functions& gl);
    /// Deletes what the current context may delete, as enterToDelete() says.
    ~ContextGroup();
    ContextGroup(const ContextGroup&) = delete;
    ContextGroup& operator=(const ContextGroup&) = delete;

    /// Founds the group with the current context. Errors: OutOfMemory.
    AoStatus found();
    /// Whether the current context is one of the group. Errors: NoContext, WrongContext.
    AoStatus check() const;
    /// Makes the current context the one that work is done in, and deletes what waits for it.
    /// Errors: those of check(), OutOfMemory, MissingCapability; then none is entered.
    AoStatus enter();
    /// Makes the containers that the entered context lacks, on a known GL state of GL state.
    /// Errors: OutOfMemory, MissingCapability.
    AoStatus makeContainers();
    /// As enter(), but to delete things only, until the group ends: makes nothing. Elsewhere than
    /// in the group, nothing will be deleted.
    void enterToDelete();
    /// After the host's code has run within a call: whether the context is still the one that was
    /// entered. Else none is entered any more. Errors: NoContext, WrongContext.
    AoStatus confirm();
    /// The context is no longer known to be current; `outer` is, if a call encloses this one.
    void leave(ContextId outer);
    /// The context that was entered; 0 outside of calls.
    ContextId current() const { return current_; }
    /// Forgets all names without a call of GL: the contexts are gone.
    void abandon();

    /// Deletes an object, now or when `owner` is entered.
    /// @param owner  the container's context; 0 for what all contexts share.
    void release(ContextId owner, std::function<void()> deletion);

    /// What must exist in each context: makeContainers() calls it where it may be missing.
    using MakeHere = std::function<AoStatus()>;
    void add(const MakeHere* container) { containers_.insert(container); }
    void remove(const MakeHere* container) { containers_.erase(container); }

private:
    struct Member {
        ContextId id = 0;
        GLuint marker = 0; ///< vertex array, with `buffer` as source of attribute 0
        GLuint buffer = 0;
        Functions::Capabilities capabilities;
    };
    struct Waiting {
        ContextId owner;
        std::function<void()> deletion;
    };

    bool ownsCurrent(const Member& member) const;
    const Member* find() const;
    Result<const Member*> addCurrent();
    void become(const Member& member);
    void deleteWaiting();

    Functions& gl_;
    std::string text_;    ///< of the shader that marks the group
    GLuint marker_ = 0;   ///< that shader
    bool gone_ = false;   ///< abandon() was called
    bool behind_ = false; ///< the context entered last may lack containers
    ContextId current_ = 0;
    ContextId latest_ = 0; ///< entered last
    std::vector<Member> members_;
    std::vector<Waiting> waiting_;
    std::set<const MakeHere*> containers_;
};

/// Enters the current context for as long as a call lasts.
class ContextScope {
public:
    explicit ContextScope(ContextGroup& group)
        : group_(group), outer_(group.current()), status_(group.enter()) {}
    ~ContextScope() { group_.leave(outer_); }
    ContextScope(const ContextScope&) = delete;
    ContextScope& operator=(const ContextScope&) = delete;

    /// Errors: as ContextGroup::enter(). Nothing may be drawn then; releasing objects is safe.
    const AoStatus& status() const { return status_; }

private:
    ContextGroup& group_;
    ContextId outer_;
    AoStatus status_;
};

/// The context that calls work in; 0 for a table without a group, whose context is the only one.
ContextId currentContext(const Functions& gl);

/// Deletes an object of a table's group as its rules demand, or at once where there is no group.
void release(const Functions& gl, ContextId owner, std::function<void()> deletion);

} // namespace aolib::gl
