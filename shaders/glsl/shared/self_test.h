// What the arithmetic self-test exchanges with its shader. Read by C++ and GLSL.
#ifndef VKBAKE_SHARED_SELF_TEST_H
#define VKBAKE_SHARED_SELF_TEST_H

#ifdef __cplusplus
namespace vkbake::shared {
constexpr unsigned self_test_group = 64;
#else
const uint self_test_group = 64;
#endif

struct SelfTestPair {
    double double_a;
    double double_b;
    float float_a;
    float float_b;
};

struct SelfTestResult {
    double double_sum;
    double double_product;
    double double_chain; // a·b + a with two roundings: contraction shows here
    float float_sum;
    float float_product;
    float float_chain;
    float unused;
};

#ifdef __cplusplus
static_assert(sizeof(SelfTestPair) == 24);
static_assert(sizeof(SelfTestResult) == 40);
} // namespace vkbake::shared
#endif

#endif
