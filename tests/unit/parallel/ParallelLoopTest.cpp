#include "parallel/ParallelLoop.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <new>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(ParallelLoop, VisitsEveryIndexOnce) {
    for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 1000U}) {
        for (const int threads : {0, 1, 3}) {
            std::vector<int> visits(count, 0);
            EXPECT_TRUE(parallelLoop(count, threads,
                                     [&](std::size_t begin, std::size_t end) {
                                         for (std::size_t i = begin; i < end; ++i) {
                                             ++visits[i];
                                         }
                                     },
                                     {}));
            EXPECT_EQ(visits, std::vector<int>(count, 1));
        }
    }
}

TEST(ParallelLoop, ReportsRisingProgressFromTheCallersThread) {
    std::vector<double> fractions;
    std::atomic<int> reports{0};
    const auto caller = std::this_thread::get_id();
    EXPECT_TRUE(parallelLoop(
        64, 2,
        [&](std::size_t, std::size_t) { // lasts until there was a report on the way
            for (int ms = 0; reports < 2 && ms < 60000; ++ms) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        },
        [&](double fraction) {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            fractions.push_back(fraction);
            ++reports;
            return true;
        }));
    ASSERT_GE(fractions.size(), 3U);
    EXPECT_EQ(fractions.front(), 0.0);
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

TEST(ParallelLoop, CancelledBeforeItStartsRunsNothing) {
    std::atomic<int> pieces{0};
    EXPECT_FALSE(parallelLoop(
        1000, 2, [&](std::size_t, std::size_t) { ++pieces; }, [](double) { return false; }));
    EXPECT_EQ(pieces, 0);
}

/// All pieces together would take seconds; the first report comes long before.
TEST(ParallelLoop, CancelledMidwayStopsSoon) {
    constexpr int allPieces = 10000;
    std::atomic<int> pieces{0};
    EXPECT_FALSE(parallelLoop(
        16 * allPieces, 2,
        [&](std::size_t, std::size_t) {
            ++pieces;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        },
        [](double fraction) { return fraction == 0.0; }));
    EXPECT_GT(pieces, 0);
    EXPECT_LT(pieces, allPieces);
}

TEST(ParallelLoop, WhatABodyThrowsComesOutAndEndsTheLoop) {
    constexpr std::size_t kCount = 100000;
    std::atomic<std::size_t> visited{0};
    double latest = 0.0;
    const auto run = [&] {
        parallelLoop(
            kCount, 4,
            [&](std::size_t begin, std::size_t end) {
                if (begin == 160) {
                    throw std::bad_alloc();
                }
                visited += end - begin;
            },
            [&](double fraction) {
                latest = fraction;
                return true;
            });
    };
    EXPECT_THROW(run(), std::bad_alloc);
    EXPECT_LT(visited, kCount);
    EXPECT_LT(latest, 1.0);
}

} // namespace
} // namespace aolib
