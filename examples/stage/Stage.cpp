#include "Stage.h"

#include <fstream>
#include <iostream>

#include <glm/gtc/matrix_transform.hpp>

namespace stage {

Camera camera() {
    const float angle = glm::radians(31.2F);
    const glm::vec3 eye(7.5F * glm::sin(angle), 4.0F, 7.5F * glm::cos(angle));
    constexpr float kAspect = static_cast<float>(kWidth) / static_cast<float>(kHeight);
    return {eye, glm::lookAt(eye, {0.0F, 0.6F, 0.0F}, {0.0F, 1.0F, 0.0F}),
            glm::perspective(glm::radians(45.0F), kAspect, 0.1F, 100.0F)};
}

Arguments parse(int argc, char** argv) {
    Arguments arguments;
    int next = 1;
    const std::string flag = argc > 1 ? argv[next] : "";
    if (flag == "--without" || flag == "--neutral") {
        arguments.ambientOcclusion = flag != "--without";
        arguments.neutral = flag == "--neutral";
        ++next;
    }
    if (next + 1 == argc && argv[next][0] != '-') {
        arguments.picture = argv[next];
    } else {
        std::cerr << "Usage: " << argv[0] << " [--without | --neutral] PICTURE.ppm\n";
    }
    return arguments;
}

int save(const std::string& path, const std::vector<std::uint8_t>& rgb) {
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << kWidth << ' ' << kHeight << "\n255\n";
    constexpr std::size_t kRow = 3 * static_cast<std::size_t>(kWidth);
    for (std::size_t y = kHeight; y-- > 0;) {
        file.write(reinterpret_cast<const char*>(rgb.data() + y * kRow),
                   static_cast<std::streamsize>(kRow));
    }
    return file.flush() ? 0 : fail(path + " cannot be written");
}

int fail(const std::string& reason) {
    std::cerr << reason << '\n';
    return 1;
}

} // namespace stage
