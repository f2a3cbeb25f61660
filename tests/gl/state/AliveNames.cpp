#include "AliveNames.h"

namespace aolib {

std::set<std::pair<char, GLuint>> aliveNames(const HostGl& gl) {
    constexpr GLuint kNames = 4096; // more than a test ever has
    std::set<std::pair<char, GLuint>> alive;
    for (GLuint name = 1; name < kNames; ++name) {
        const auto note = [&](char kind, GLboolean is) {
            if (is == GL_TRUE) {
                alive.insert({kind, name});
            }
        };
        note('t', gl.IsTexture(name));
        note('b', gl.IsBuffer(name));
        note('f', gl.IsFramebuffer(name));
        note('r', gl.IsRenderbuffer(name));
        note('v', gl.IsVertexArray(name));
        note('q', gl.IsQuery(name));
        note('s', gl.IsSampler(name));
        note('p', gl.IsProgram(name));
        note('h', gl.IsShader(name));
    }
    return alive;
}

} // namespace aolib
