// A tracer whose memory runs out: operator new of this whole program can be told to refuse.
#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#include <aolib/RayTracing.h>
#include <gtest/gtest.h>

namespace {

/// Larger blocks than this are refused.
std::atomic<std::size_t> largestBlock{std::numeric_limits<std::size_t>::max()};

class Shortage {
public:
    explicit Shortage(std::size_t largest) { largestBlock = largest; }
    ~Shortage() { largestBlock = std::numeric_limits<std::size_t>::max(); }
};

} // namespace

// Not inlined: GCC 12 would take malloc and delete for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
    void* const block = size > largestBlock ? nullptr : std::malloc(size);
    if (block == nullptr) {
        throw std::bad_alloc();
    }
    return block;
}

[[gnu::noinline]] void operator delete(void* block) noexcept {
    std::free(block);
}

[[gnu::noinline]] void operator delete(void* block, std::size_t /*size*/) noexcept {
    std::free(block);
}

namespace aolib {
namespace {

constexpr double patience = 6e4; ///< milliseconds

TexelRequest largeRequest() {
    TexelRequest request;
    request.faceSize = 512;
    request.width = 512;
    request.height = 512;
    request.rays = 1;
    request.radius = 1.0F;
    return request;
}

TEST(OutOfMemory, OfAResultIsAStatus) {
    auto tracer = createTexelTracer(1);
    ASSERT_TRUE(tracer);
    (*tracer)->setScene({}, {});
    {
        const Shortage shortage(512 * 512);
        (*tracer)->request({largeRequest()});
        ASSERT_TRUE((*tracer)->wait(patience));
    }
    EXPECT_EQ((*tracer)->status().code(), StatusCode::OutOfMemory);
    EXPECT_EQ((*tracer)->pending(), 0U);
    // And it goes on.
    (*tracer)->request({largeRequest()});
    ASSERT_TRUE((*tracer)->wait(patience));
    EXPECT_EQ((*tracer)->take(1).size(), 1U);
}

TEST(OutOfMemory, OfTheSceneIsAStatus) {
    auto tracer = createTexelTracer(1);
    ASSERT_TRUE(tracer);
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 3 * 20000; ++i) {
        positions.emplace_back(float(i % 3), float(i % 2), float(i));
        indices.push_back(i);
    }
    {
        const Shortage shortage(4096);
        (*tracer)->setScene(std::move(positions), std::move(indices));
        (*tracer)->request({largeRequest()});
        ASSERT_TRUE((*tracer)->wait(patience));
    }
    EXPECT_EQ((*tracer)->status().code(), StatusCode::OutOfMemory);
    EXPECT_EQ((*tracer)->pending(), 0U);
}

} // namespace
} // namespace aolib
