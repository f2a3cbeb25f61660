#include "scene/Flatten.h"

#include <string>

namespace aolib {

namespace {

AoStatus incomplete(const char* primitive, const char* rule, std::size_t count) {
    return {StatusCode::IncompletePrimitive, std::string(primitive) + " needs " + rule +
                                                 "; this run has " + std::to_string(count) +
                                                 " indices"};
}

} // namespace

AoStatus flatten(AoPrimitive primitive, std::span<const std::uint32_t> run,
                 std::vector<std::uint32_t>& triangles) {
    const std::size_t n = run.size();
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.insert(triangles.end(), {run[a], run[b], run[c]});
    };
    if (n == 0) {
        return {};
    }
    switch (primitive) {
    case AO_TRIANGLES:
        if (n % 3 != 0) {
            return incomplete("AO_TRIANGLES", "a multiple of three", n);
        }
        triangles.insert(triangles.end(), run.begin(), run.end());
        return {};
    case AO_TRIANGLE_STRIP:
        if (n < 3) {
            return incomplete("AO_TRIANGLE_STRIP", "at least three", n);
        }
        for (std::size_t i = 0; i + 2 < n; ++i) {
            i % 2 == 0 ? add(i, i + 1, i + 2) : add(i + 1, i, i + 2);
        }
        return {};
    case AO_TRIANGLE_FAN:
        if (n < 3) {
            return incomplete("AO_TRIANGLE_FAN", "at least three", n);
        }
        for (std::size_t i = 1; i + 1 < n; ++i) {
            add(0, i, i + 1);
        }
        return {};
    case AO_QUADS:
        if (n % 4 != 0) {
            return incomplete("AO_QUADS", "a multiple of four", n);
        }
        for (std::size_t i = 0; i < n; i += 4) {
            add(i, i + 1, i + 2);
            add(i, i + 2, i + 3);
        }
        return {};
    case AO_QUAD_STRIP:
        if (n < 4 || n % 2 != 0) {
            return incomplete("AO_QUAD_STRIP", "an even number, at least four", n);
        }
        for (std::size_t i = 0; i + 3 < n; i += 2) {
            add(i, i + 1, i + 3);
            add(i, i + 3, i + 2);
        }
        return {};
    }
    return {StatusCode::InvalidPrimitive,
            std::to_string(static_cast<int>(primitive)) + " is not an AoPrimitive"};
}

} // namespace aolib
