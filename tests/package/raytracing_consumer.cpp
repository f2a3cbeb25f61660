// Traces a texel below a ceiling that closes everything off: nothing of the sky is visible.
#include <iostream>

#include <aolib/RayTracing.h>

int main() {
    auto tracer = aolib::createTexelTracer(1);
    if (!tracer) {
        std::cout << tracer.status().message() << '\n';
        return 1;
    }
    const float far = 1.0e4F;
    (*tracer)->setScene({{-far, 0, -far},
                         {far, 0, -far},
                         {0, 0, far},
                         {-far, 2, -far},
                         {far, 2, -far},
                         {0, 2, far}},
                        {0, 1, 2, 3, 4, 5});
    aolib::TexelRequest texel;
    texel.centre = {0.0F, 1.0F, 0.0F};
    texel.faceSize = 1;
    texel.face = 3; // down
    texel.width = texel.height = 1;
    texel.rays = 16;
    texel.radius = 100.0F;
    (*tracer)->request({texel});
    (*tracer)->wait(10000.0);
    const auto traced = (*tracer)->take(1);
    const bool closed = traced.size() == 1 && traced[0].visibility.at(0) < 0.1F;
    std::cout << (closed ? "closed" : "not closed: " + (*tracer)->status().message()) << '\n';
    return closed ? 0 : 1;
}
