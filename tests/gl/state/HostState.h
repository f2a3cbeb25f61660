#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "HostGl.h"
#include "HostObjects.h"

namespace aolib {

/// A piece of state and how reports call it.
struct NamedQuery {
    const char* name;
    GLenum query;
};
using NamedQueries = std::initializer_list<NamedQuery>;

/// Collects values one after the other; their names too, when they are asked for.
class StateRecorder {
public:
    explicit StateRecorder(bool named) : named_(named) {}

    void value(const char* name, double value) { value_(name, -1, -1, value); }
    void value(const char* name, std::size_t index, double value) {
        value_(name, static_cast<int>(index), -1, value);
    }
    void value(const char* name, std::size_t index, const char* part, double value) {
        value_(name, static_cast<int>(index), -1, value, part);
    }
    template <typename T>
    void values(const char* name, std::size_t index, const T* first, int count) {
        for (int i = 0; i < count; ++i) {
            value_(name, static_cast<int>(index), i, static_cast<double>(first[i]));
        }
    }

    std::vector<double> recorded;
    std::vector<std::string> names; ///< one per value, or none

private:
    void value_(const char* name, int index, int component, double value,
                const char* part = nullptr);
    bool named_;
};

/// An independent picture of the context: every piece of state that GL can be asked for, and the
/// content of the host's own objects. Knows nothing of aolib's StateGuard. Raises no GL error.
class HostState {
public:
    using Snapshot = std::vector<double>;

    HostState(const HostGl& gl, const HostObjects& objects) : gl_(gl), objects_(objects) {}

    Snapshot snapshot() const;
    /// "GL_DEPTH_FUNC: 513 -> 515", one line each; empty when both are equal.
    std::string difference(const Snapshot& before, const Snapshot& after) const;
    /// How many values a snapshot holds, and each one's name.
    std::vector<std::string> names() const;

private:
    void record(StateRecorder& to) const;
    // Each in a file of its own: HostState<Part>.cpp.
    void recordSwitches(StateRecorder& to) const;
    void recordNumbers(StateRecorder& to) const;
    void recordArrays(StateRecorder& to) const;
    void recordTextureUnits(StateRecorder& to) const;
    void recordBuffers(StateRecorder& to) const;
    void recordVertexArray(StateRecorder& to) const;
    void recordFramebuffers(StateRecorder& to) const;
    void recordRunning(StateRecorder& to) const;
    void recordObjects(StateRecorder& to) const;
    void recordFixedFunction(StateRecorder& to) const;
    void recordPixelTransfer(StateRecorder& to) const;

    void integers(StateRecorder& to, const char* name, GLenum query, int count = 1) const;
    void floats(StateRecorder& to, const char* name, GLenum query, int count = 1) const;

    const HostGl& gl_;
    const HostObjects& objects_;
};

} // namespace aolib
