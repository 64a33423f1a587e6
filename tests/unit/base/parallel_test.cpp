#include "base/parallel.hpp"

#include <atomic>
#include <cfenv>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace vkbake {
namespace {

TEST(ParallelRanges, VisitsEveryIndexOnceInShortRanges) {
    for (const int threads : {0, 1, 2}) {
        std::vector<std::atomic<int>> visits(1001);
        parallel_ranges(visits.size(), 7, threads, [&](std::size_t begin, std::size_t end) {
            ASSERT_LE(end - begin, 7U);
            for (std::size_t index = begin; index < end; ++index) {
                ++visits[index];
            }
        });
        for (const std::atomic<int>& count : visits) {
            EXPECT_EQ(count, 1);
        }
    }
}

TEST(ParallelRanges, TwoCallsAtATimeHaveTwoWorkers) {
    for (const int threads : {0, 1, 2, 1000}) {
        std::vector<std::atomic<int>> busy(worker_count(threads));
        std::atomic<int> clashes{0};
        std::atomic<int> calls{0};
        parallel_ranges_by_worker(2000, 1, threads, [&](std::size_t, std::size_t, std::size_t worker) {
            clashes += busy.at(worker).exchange(1);
            ++calls;
            busy.at(worker) = 0;
        });
        EXPECT_EQ(clashes, 0);
        EXPECT_EQ(calls, 2000);
    }
}

TEST(ParallelRanges, AskForNoMoreWorkersThanTheMachineHas) {
    EXPECT_EQ(worker_count(1), 1U);
    EXPECT_GE(worker_count(0), 1U);
    EXPECT_EQ(worker_count(1000), worker_count(0));
    testing::internal::CaptureStderr(); // oneTBB would complain there
    parallel_ranges(10, 1, 1000, [](std::size_t, std::size_t) {});
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ParallelRanges, HandsOnExceptions) {
    EXPECT_THROW(parallel_ranges(10, 1, 2, [](std::size_t, std::size_t) { throw std::runtime_error("stop"); }),
                 std::runtime_error);
}

TEST(ParallelRanges, RoundsToNearestWhateverTheHostHasSet) {
    std::fesetround(FE_UPWARD);
    std::atomic<int> wrong{0};
    parallel_ranges(64, 1, 2, [&](std::size_t, std::size_t) { wrong += std::fegetround() != FE_TONEAREST ? 1 : 0; });
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(after, FE_UPWARD);
}

TEST(ParallelBoth, RunsBoth) {
    int first = 0;
    int second = 0;
    parallel_both([&] { first = 1; }, [&] { second = 2; });
    EXPECT_EQ(first + second, 3);
}

} // namespace
} // namespace vkbake
