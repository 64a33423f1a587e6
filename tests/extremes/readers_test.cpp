// Whatever is in a file, a reader gives a value or one error that says so.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "amount.hpp"
#include "extremes/damage.hpp"
#include "unit/write/test_folder.hpp"

namespace vkbake::test {
namespace {

TEST(Readers, DamagedFilesEndInAValueOrARefusal) {
    const TestFolder folder;
    Readers readers(folder.path());
    for (const Readers::Kind kind : Readers::kinds) {
        SCOPED_TRACE(Readers::name(kind));
        int refused = 0;
        constexpr int tries = amount(25, 8);
        for (int seed = 0; seed < tries; ++seed) {
            ASSERT_NO_THROW(refused += readers.read_damaged(kind, static_cast<std::uint64_t>(seed)) ? 0 : 1) << seed;
        }
        EXPECT_GT(refused, tries / 10);
    }
}

#ifndef __SANITIZE_ADDRESS__ // whose own memory would be counted
/// 60 bytes that announce 20000² texels, 4.8 GB: refused at the first row, before there is memory for the others.
TEST(Readers, AFewBytesThatAnnounceAHugePictureGetNoMemoryForIt) {
    const TestFolder folder;
    std::ofstream(folder / "huge.hdr", std::ios::binary)
        << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 20000 +X 20000\n\x02\x02";
    EXPECT_THROW((void)read_image(folder / "huge.hdr"), Error);
    rusage usage{};
    ASSERT_EQ(getrusage(RUSAGE_SELF, &usage), 0);
    EXPECT_LT(usage.ru_maxrss, 2L << 20U); // kB
}
#endif

} // namespace
} // namespace vkbake::test
