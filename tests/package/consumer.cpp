// The smallest host: it has no OpenGL, and aolib must say so.
#include <iostream>

#include <aolib/aolib.h>

int main() {
    const auto ao = aolib::AmbientOcclusion::create({});
    std::cout << aolib::statusName(ao.status().code()) << ": " << ao.status().message() << '\n';
    return ao.status().code() == aolib::StatusCode::NoContext ? 0 : 1;
}
