#include "gpu/programs.hpp"

#include <algorithm>
#include <array>

#include "gpu/recording.hpp"
#include "gpu/spirv.hpp"

namespace vkbake::gpu {

namespace {

vk::raii::ShaderModule make_module(const vk::raii::Device& device, std::string_view name) {
    const auto modules = spirv_modules();
    const auto found = std::ranges::find(modules, name, &SpirvModule::name);
    if (found == modules.end()) {
        throw Error(ErrorKind::bake_failed,
                    "gpu: no shader named " + std::string(name) + "; build the target `spirv`, then the program again");
    }
    return {device, vk::ShaderModuleCreateInfo({}, found->words.size_bytes(), found->words.data())};
}

vk::DescriptorType descriptor_type(Slot slot) {
    switch (slot) {
    case Slot::storage_buffer:
        return vk::DescriptorType::eStorageBuffer;
    case Slot::storage_image:
        return vk::DescriptorType::eStorageImage;
    case Slot::sampled_image:
        break;
    }
    return vk::DescriptorType::eCombinedImageSampler;
}

void make_layout(const vk::raii::Device& device, Program& program) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < program.slots.size(); ++i) {
        bindings.emplace_back(i, descriptor_type(program.slots[i]), 1, program.stages);
    }
    program.set_layout = vk::raii::DescriptorSetLayout(device, vk::DescriptorSetLayoutCreateInfo({}, bindings));
    const vk::PushConstantRange constants(program.stages, 0, program.constant_bytes);
    vk::PipelineLayoutCreateInfo info({}, *program.set_layout);
    if (program.constant_bytes > 0) {
        info.setPushConstantRanges(constants);
    }
    program.layout = vk::raii::PipelineLayout(device, info);
}

vk::PipelineColorBlendAttachmentState blend_state(bool blend) {
    using enum vk::ColorComponentFlagBits;
    vk::PipelineColorBlendAttachmentState state;
    state.colorWriteMask = eR | eG | eB | eA;
    state.blendEnable = blend ? VK_TRUE : VK_FALSE;
    state.srcColorBlendFactor = vk::BlendFactor::eSrcAlpha;
    state.dstColorBlendFactor = vk::BlendFactor::eOneMinusSrcAlpha;
    state.srcAlphaBlendFactor = vk::BlendFactor::eOne;
    state.dstAlphaBlendFactor = vk::BlendFactor::eOneMinusSrcAlpha;
    return state;
}

vk::raii::Pipeline make_pipeline(const vk::raii::Device& device, const Program& program,
                                 const GraphicsDescription& description) {
    const vk::raii::ShaderModule vertex = make_module(device, description.vertex_shader);
    const vk::raii::ShaderModule fragment = make_module(device, description.fragment_shader);
    const std::array stages{
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main")};

    std::vector<vk::Format> formats;
    std::ranges::transform(description.colors, std::back_inserter(formats), vulkan_format);
    const vk::Format depth_format = description.depth_target ? vk::Format::eD32Sfloat : vk::Format::eUndefined;
    const vk::PipelineRenderingCreateInfo targets(0, formats, depth_format);

    const vk::PipelineVertexInputStateCreateInfo no_attributes;
    const vk::PipelineInputAssemblyStateCreateInfo triangles({}, vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.cullMode = description.cull_back ? vk::CullModeFlagBits::eBack : vk::CullModeFlagBits::eNone;
    rasterization.frontFace = vk::FrontFace::eCounterClockwise;
    rasterization.lineWidth = 1.0F;
    const vk::PipelineMultisampleStateCreateInfo one_sample;
    const bool tested = description.depth_test != DepthTest::none;
    const vk::PipelineDepthStencilStateCreateInfo depth(
        {}, tested ? VK_TRUE : VK_FALSE, tested ? VK_TRUE : VK_FALSE,
        description.depth_test == DepthTest::greater ? vk::CompareOp::eGreater : vk::CompareOp::eLess);
    const std::vector blends(formats.size(), blend_state(description.blend));
    const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, {}, blends);
    const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamic_states);

    vk::GraphicsPipelineCreateInfo info({}, stages, &no_attributes, &triangles, nullptr, &viewport, &rasterization,
                                        &one_sample, &depth, &blend, &dynamic, *program.layout);
    info.pNext = &targets;
    return {device, nullptr, info};
}

std::unique_ptr<Program> make_program(const vk::raii::Device& device, const std::vector<Slot>& slots,
                                      std::uint32_t constant_bytes, vk::ShaderStageFlags stages) {
    auto program = std::make_unique<Program>();
    program->slots = slots;
    program->constant_bytes = constant_bytes;
    program->stages = stages;
    make_layout(device, *program);
    return program;
}

} // namespace

ComputeProgram::ComputeProgram(Context& context, const ComputeDescription& description) {
    translated("gpu: program " + std::string(description.shader), [&] {
        const vk::raii::Device& device = context.state().device;
        m_program =
            make_program(device, description.slots, description.constant_bytes, vk::ShaderStageFlagBits::eCompute);
        const vk::raii::ShaderModule shader = make_module(device, description.shader);
        const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *shader, "main");
        m_program->pipeline =
            vk::raii::Pipeline(device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *m_program->layout));
    });
}

ComputeProgram::~ComputeProgram() = default;
ComputeProgram::ComputeProgram(ComputeProgram&&) noexcept = default;
ComputeProgram& ComputeProgram::operator=(ComputeProgram&&) noexcept = default;

GraphicsProgram::GraphicsProgram(Context& context, const GraphicsDescription& description) {
    translated("gpu: program " + std::string(description.fragment_shader), [&] {
        const vk::raii::Device& device = context.state().device;
        m_program = make_program(device, description.slots, description.constant_bytes,
                                 vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment);
        m_program->pipeline = make_pipeline(device, *m_program, description);
    });
}

GraphicsProgram::~GraphicsProgram() = default;
GraphicsProgram::GraphicsProgram(GraphicsProgram&&) noexcept = default;
GraphicsProgram& GraphicsProgram::operator=(GraphicsProgram&&) noexcept = default;

} // namespace vkbake::gpu
