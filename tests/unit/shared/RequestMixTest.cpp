#include "backbone/texels/RequestMix.h"

#include <gtest/gtest.h>

namespace aolib {
namespace {

std::vector<TexelRequest> requests(std::uint64_t first, int count, int rays) {
    std::vector<TexelRequest> made;
    for (int i = 0; i < count; ++i) {
        TexelRequest request;
        request.key = first + static_cast<std::uint64_t>(i);
        request.width = request.height = 4;
        request.rays = rays;
        made.push_back(request);
    }
    return made;
}

std::vector<std::uint64_t> keys(const RequestMix& mix) {
    std::vector<std::uint64_t> all;
    for (const TexelRequest& request : mix.mixed()) {
        all.push_back(request.key);
    }
    return all;
}

TEST(RequestMixTest, OneAskerKeepsTheOrder) {
    RequestMix mix;
    mix.set(0, requests(10, 3, 16));
    EXPECT_EQ(keys(mix), (std::vector<std::uint64_t>{10, 11, 12}));
    mix.answered(0, 10);
    mix.answered(0, 99);
    EXPECT_EQ(keys(mix), (std::vector<std::uint64_t>{11, 12}));
    EXPECT_EQ(mix.count(0), 2U);
}

TEST(RequestMixTest, AnothersRequestsStayAndTakeTurns) {
    RequestMix mix;
    mix.set(0, requests(10, 3, 16));
    mix.set(5, requests(50, 3, 16));
    EXPECT_EQ(keys(mix), (std::vector<std::uint64_t>{10, 50, 11, 51, 12, 52}));
    mix.set(0, {});
    EXPECT_EQ(keys(mix), (std::vector<std::uint64_t>{50, 51, 52}));
}

TEST(RequestMixTest, WhoHasHadFewerRaysIsNext) {
    RequestMix mix;
    mix.set(0, requests(10, 4, 16));
    mix.set(1, requests(20, 2, 48));
    EXPECT_EQ(keys(mix), (std::vector<std::uint64_t>{10, 20, 11, 12, 13, 21}));
    mix.answered(0, 10);
    mix.answered(0, 11);
    EXPECT_EQ(keys(mix).front(), 20U) << "across submissions, too";
    mix.set(2, requests(30, 1, 16));
    EXPECT_EQ(keys(mix).front(), 20U) << "a newcomer does not keep the others waiting";
}

} // namespace
} // namespace aolib
