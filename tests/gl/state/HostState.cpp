#include "HostState.h"

#include <array>
#include <sstream>
#include <utility>

namespace aolib {

void StateRecorder::value_(const char* name, int index, int component, double value,
                           const char* part) {
    recorded.push_back(value);
    if (!named_) {
        return;
    }
    std::string text = name;
    if (index >= 0) {
        text.append("[").append(std::to_string(index)).append("]");
    }
    if (part != nullptr) {
        text.append(".").append(part);
    }
    if (component >= 0) {
        text.append(".").append(std::to_string(component));
    }
    names.push_back(text);
}

HostState::Snapshot HostState::snapshot() const {
    StateRecorder recorder(false);
    record(recorder);
    return std::move(recorder.recorded);
}

std::vector<std::string> HostState::names() const {
    StateRecorder recorder(true);
    record(recorder);
    return std::move(recorder.names);
}

std::string HostState::difference(const Snapshot& before, const Snapshot& after) const {
    if (before == after) {
        return {};
    }
    if (before.size() != after.size()) {
        return "the snapshots are of different sizes";
    }
    const std::vector<std::string> named = names();
    std::ostringstream lines;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] != after[i]) {
            lines << named[i] << ": " << before[i] << " -> " << after[i] << "\n";
        }
    }
    return lines.str();
}

void HostState::record(StateRecorder& to) const {
    recordSwitches(to);
    recordNumbers(to);
    recordArrays(to);
    recordTextureUnits(to);
    recordBuffers(to);
    recordVertexArray(to);
    recordFramebuffers(to);
    recordRunning(to);
    recordObjects(to);
    if (gl_.has.compatibility) {
        recordFixedFunction(to);
        recordPixelTransfer(to);
    }
}

void HostState::integers(StateRecorder& to, const char* name, GLenum query, int count) const {
    std::array<GLint, 16> values{};
    gl_.GetIntegerv(query, values.data());
    to.values(name, 0, values.data(), count);
}

void HostState::floats(StateRecorder& to, const char* name, GLenum query, int count) const {
    std::array<GLfloat, 16> values{};
    gl_.GetFloatv(query, values.data());
    to.values(name, 0, values.data(), count);
}

} // namespace aolib
