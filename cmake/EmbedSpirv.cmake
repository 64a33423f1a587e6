# embed_spirv(TARGET): turns the checked-in spirv/*.spv into a source file of TARGET that defines gpu::spirv_modules().
# A normal build needs no shader compiler; the target `spirv` rebuilds the modules from shaders/glsl.
