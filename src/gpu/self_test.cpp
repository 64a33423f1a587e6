// Does the device round as the host does?
#include <bit>
#include <cmath>

#include "gpu/commands.hpp"
#include "gpu/context.hpp"
#include "self_test.h"

namespace vkbake::gpu {

namespace {

/// Weyl's sequence through a finaliser (Steele, Lea & Flood 2014, SplitMix64).
std::uint64_t mixed(std::uint64_t n) {
    n *= 0x9E3779B97F4A7C15U;
    n = (n ^ (n >> 30U)) * 0xBF58476D1CE4E5B9U;
    n = (n ^ (n >> 27U)) * 0x94D049BB133111EBU;
    return n ^ (n >> 31U);
}

/// Any sign and mantissa (runs of ones and zeros among them, where rounding carries), exponents near that of 1.
double operand(std::uint64_t n) {
    const std::uint64_t bits = mixed(n);
    const std::uint64_t run = (std::uint64_t{1} << (bits % 52U)) - 1U;
    std::uint64_t mantissa = mixed(bits) & ((std::uint64_t{1} << 52U) - 1U);
    mantissa = (bits >> 60U) % 4U == 0U ? mantissa & ~run : (bits >> 60U) % 4U == 1U ? mantissa | run : mantissa;
    const std::uint64_t exponent = 1023U - 30U + (bits >> 8U) % 60U;
    return std::bit_cast<double>((bits & (std::uint64_t{1} << 63U)) | (exponent << 52U) | mantissa);
}

std::vector<shared::SelfTestPair> operands() {
    constexpr std::uint32_t count = 4096;
    std::vector<shared::SelfTestPair> pairs(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        shared::SelfTestPair& pair = pairs[i];
        pair.double_a = operand(2U * i);
        pair.double_b = operand(2U * i + 1U);
        pair.float_a = static_cast<float>(pair.double_a);
        pair.float_b = static_cast<float>(pair.double_b);
    }
    return pairs;
}

bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool is_exact(const shared::SelfTestPair& in, const shared::SelfTestResult& out) {
    return same_bits(out.float_sum, in.float_a + in.float_b) && same_bits(out.float_product, in.float_a * in.float_b) &&
           same_bits(out.float_chain, in.float_a * in.float_b + in.float_a) &&
           same_bits(out.double_sum, in.double_a + in.double_b) &&
           same_bits(out.double_product, in.double_a * in.double_b) &&
           same_bits(out.double_chain, in.double_a * in.double_b + in.double_a);
}

} // namespace

bool Context::arithmetic_is_exact() {
    const std::vector<shared::SelfTestPair> pairs = operands();
    const auto count = static_cast<std::uint32_t>(pairs.size());
    Buffer input(*this, pairs.size() * sizeof(shared::SelfTestPair), Memory::upload);
    input.upload(std::as_bytes(std::span(pairs)));
    Buffer output(*this, pairs.size() * sizeof(shared::SelfTestResult), Memory::read_back);
    const ComputeProgram program(
        *this,
        {.shader = "self_test.comp", .slots = {Slot::storage_buffer, Slot::storage_buffer}, .constant_bytes = 0});
    run([&](Commands& commands) {
        const std::array resources{storage(input), storage(output)};
        commands.dispatch(program, {count / shared::self_test_group}, resources);
    });
    const auto results = output.as<shared::SelfTestResult>();
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!is_exact(pairs[i], results[i])) {
            return false;
        }
    }
    return true;
}

} // namespace vkbake::gpu
