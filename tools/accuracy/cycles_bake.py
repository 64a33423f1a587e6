# What Blender's Cycles takes for a map with the UVs of TEXCOORD_1: prints the seconds of its bake call alone.
#   blender -b -P cycles_bake.py -- SCENE SIZE SKY|ao SAMPLES
import sys
import time

import bpy
import numpy

numpy.bool = bool  # Blender 3.4's reader of glTF uses the name, which NumPy 1.24 has dropped
scene_file, size, sky, samples = sys.argv[sys.argv.index("--") + 1:][:4]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=scene_file)
scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = int(samples)
scene.cycles.use_adaptive_sampling = False
scene.cycles.use_denoising = False
scene.world = bpy.data.worlds.new("sky")
scene.world.light_settings.distance = 1e6
if sky != "ao":
    scene.world.use_nodes = True
    nodes = scene.world.node_tree
    texture = nodes.nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(sky)
    nodes.links.new(texture.outputs["Color"], nodes.nodes["Background"].inputs["Color"])
image = bpy.data.images.new("lightmap", int(size), int(size), float_buffer=True)
meshes = [o for o in scene.objects if o.type == "MESH"]
for thing in meshes:
    thing.select_set(True)
    thing.data.uv_layers.active_index = 1
    if not thing.data.materials:
        thing.data.materials.append(bpy.data.materials.new("plain"))
    for material in thing.data.materials:
        material.use_nodes = True
        node = material.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = image
        material.node_tree.nodes.active = node
bpy.context.view_layer.objects.active = meshes[0]
start = time.monotonic()
if sky == "ao":
    bpy.ops.object.bake(type="AO", margin=0)
else:
    bpy.ops.object.bake(type="DIFFUSE", pass_filter={"DIRECT"}, margin=0)
print(f"cycles-seconds {time.monotonic() - start:.3f}")
