// Adds and multiplies what the host gives; the host compares the bits.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "self_test.h"

layout(local_size_x = self_test_group) in;

layout(std430, set = 0, binding = 0) readonly buffer Input { SelfTestPair pairs[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Output { SelfTestResult results[]; };

void main() {
    const SelfTestPair pair = pairs[gl_GlobalInvocationID.x];
    precise double double_sum = pair.double_a + pair.double_b;
    precise double double_product = pair.double_a * pair.double_b;
    precise double double_chain = double_product + pair.double_a;
    precise float float_sum = pair.float_a + pair.float_b;
    precise float float_product = pair.float_a * pair.float_b;
    precise float float_chain = float_product + pair.float_a;
    results[gl_GlobalInvocationID.x] =
        SelfTestResult(double_sum, double_product, double_chain, float_sum, float_product, float_chain, 0.0);
}
