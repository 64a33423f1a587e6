# One scene under six kinds of light, baked by vkbake and by Blender's Cycles: a row of a table for each. Ours is baked at
# four times the size and averaged over the half texel that Cycles averages over; the noise is that of two seeds.
#   blender -b -P cycles_light.py -- VKBAKE CYCLES_SAMPLES RAYS
import json
import math
import os
import struct
import subprocess
import sys
import tempfile

import bpy
import mathutils
import numpy

numpy.bool = bool  # Blender 3.4's reader of glTF uses the name, which NumPy 1.24 has dropped
vkbake, samples, rays = sys.argv[sys.argv.index("--") + 1:][:3]
SIZE, FINER = 64, 4
work = tempfile.TemporaryDirectory()


def quad(corner, u, v, chart):
    """Corners of corner + u, v (front: u × v), and their UVs: chart is x, y, width, height in texels."""
    corner, u, v = map(numpy.array, (corner, u, v))
    points = [corner, corner + u, corner + u + v, corner + v]
    x, y, w, h = chart
    uvs = [(x / SIZE, (y + h) / SIZE), ((x + w) / SIZE, (y + h) / SIZE), ((x + w) / SIZE, y / SIZE), (x / SIZE, y / SIZE)]
    return points, uvs, numpy.cross(u, v) / numpy.linalg.norm(numpy.cross(u, v))


# A floor, two walls, a box that stands on the floor, a small panel that looks down. Charts are whole texels, apart.
FACES = {
    "floor": [quad((-2, 0, 2), (4, 0, 0), (0, 0, -4), (1, 1, 32, 32))],
    "back": [quad((-2, 0, -2), (4, 0, 0), (0, 3, 0), (34, 1, 28, 24))],
    "side": [quad((-2, 0, 2), (0, 0, -4), (0, 3, 0), (34, 27, 28, 24))],
    "box": [quad((-0.5, 0.01, 0.5), (1, 0, 0), (0, 1, 0), (1, 35, 8, 8)),
            quad((0.5, 0.01, 0.5), (0, 0, -1), (0, 1, 0), (10, 35, 8, 8)),
            quad((0.5, 0.01, -0.5), (-1, 0, 0), (0, 1, 0), (19, 35, 8, 8)),
            quad((-0.5, 0.01, -0.5), (0, 0, 1), (0, 1, 0), (1, 45, 8, 8)),
            quad((-0.5, 1.01, 0.5), (1, 0, 0), (0, 0, -1), (10, 45, 8, 8))],
    "panel": [quad((0.6, 2.4, -0.6), (0.5, 0, 0), (0, 0, 0.5), (19, 45, 8, 8))],
}
ALBEDO = {"floor": (0.6, 0.6, 0.6), "back": (0.7, 0.25, 0.2), "side": (0.2, 0.3, 0.7), "box": (0.8, 0.8, 0.8),
          "panel": (0.5, 0.5, 0.5)}
PANEL_RADIANCE = 8.0
SUN_TO = (-0.45, -1.0, -0.35)
LAMP_AT, SPOT_TO = (1.2, 2.2, 1.1), (0.0, 0.3, -0.4)


def write_scene(file, light, emits):
    binary, views, accessors, primitives, materials = b"", [], [], [], []

    def add(values, kind, component, number):
        nonlocal binary
        data = numpy.array(values, dtype=number)
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": data.nbytes})
        accessor = {"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind}
        if kind == "VEC3":
            accessor |= {"min": data.min(0).tolist(), "max": data.max(0).tolist()}
        accessors.append(accessor)
        binary += data.tobytes() + b"\0" * (-data.nbytes % 4)
        return len(accessors) - 1

    for name, quads in FACES.items():
        points, uvs, normals, indices = [], [], [], []
        for corners, places, normal in quads:
            first = len(points)
            points += [corner.tolist() for corner in corners]
            uvs += places
            normals += [normal.tolist()] * 4
            indices += [first, first + 1, first + 2, first, first + 2, first + 3]
        primitives.append({"attributes": {"POSITION": add(points, "VEC3", 5126, "<f4"), "NORMAL": add(normals, "VEC3", 5126, "<f4"),
                                          "TEXCOORD_0": add(uvs, "VEC2", 5126, "<f4"), "TEXCOORD_1": add(uvs, "VEC2", 5126, "<f4")},
                           "indices": add(indices, "SCALAR", 5123, "<u2"), "material": len(materials)})
        materials.append({"name": name, "pbrMetallicRoughness": {"baseColorFactor": [*ALBEDO[name], 1.0], "metallicFactor": 0.0}})
        if name == "panel" and emits:
            materials[-1] |= {"emissiveFactor": [1.0, 1.0, 1.0],
                              "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": PANEL_RADIANCE}}}
    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"name": "room", "mesh": 0}],
            "meshes": [{"primitives": primitives}], "materials": materials, "accessors": accessors, "bufferViews": views,
            "buffers": [{"byteLength": len(binary)}], "extensionsUsed": ["KHR_materials_emissive_strength"]}
    if light:
        at, to, definition = light
        turn = mathutils.Vector(to).to_track_quat("-Z", "Y")
        gltf["extensionsUsed"].append("KHR_lights_punctual")
        gltf["extensions"] = {"KHR_lights_punctual": {"lights": [definition]}}
        gltf["scenes"][0]["nodes"].append(1)
        gltf["nodes"].append({"translation": at, "rotation": [turn.x, turn.y, turn.z, turn.w],
                              "extensions": {"KHR_lights_punctual": {"light": 0}}})
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    with open(file, "wb") as out:
        out.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)))
        out.write(struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary)


def write_sky(file):
    """Brighter towards +X and upwards, blue above and green below."""
    texels = bytearray()
    for row in range(64):
        for column in range(128):
            up = math.cos(math.pi * (row + 0.5) / 64)
            around = math.cos(2 * math.pi * ((column + 0.5) / 128 - 0.5))
            colour = [0.5 + 0.3 * up + 0.2 * around, 0.6 - 0.1 * up, 0.7 + 0.25 * up]
            mantissa, exponent = math.frexp(max(colour))
            texels += bytes([int(value / max(colour) * mantissa * 256) for value in colour] + [exponent + 128])
    with open(file, "wb") as out:
        out.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n" + texels)


def pixels(image):
    return numpy.array(image.pixels[:], dtype=numpy.float64).reshape(image.size[1], image.size[0], 4)[::-1]


def ours(scene, flags, seed):
    folder = tempfile.mkdtemp(dir=work.name)
    subprocess.run([vkbake, "bake", scene, "-o", folder, "--quiet", "--uv", "trust", "--size", str(SIZE * FINER), "--rays", rays,
                    "--bounce-rays", rays, "--padding", "0", "--seed", str(seed), *flags], check=True, stdout=subprocess.DEVNULL)
    name, = os.listdir(folder + "/lightmaps")
    image = bpy.data.images.load(f"{folder}/lightmaps/{name}")
    image.colorspace_settings.name = "Non-Color"
    fine = pixels(image)[..., :3].reshape(SIZE, FINER, SIZE, FINER, 3)
    middle = slice(FINER // 4, FINER - FINER // 4)
    return fine[:, middle, :, middle].mean(axis=(1, 3))


def blender_lamp(kind, at, to, energy, radius, cone=0.0):
    data = bpy.data.lights.new("lamp", kind)
    data.energy = energy
    if kind == "SUN":
        data.angle = radius
    else:
        data.shadow_soft_size = radius
    if kind == "SPOT":
        data.spot_size, data.spot_blend = 2.0 * cone, 0.0
    thing = bpy.data.objects.new("lamp", data)
    to_blender = lambda v: mathutils.Vector((v[0], -v[2], v[1]))
    thing.location = to_blender(at)
    thing.rotation_euler = to_blender(to).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.collection.objects.link(thing)


def theirs(scene_file, sky, lamp, emits, bounces, seeds):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=scene_file)
    for thing in [o for o in bpy.context.scene.objects if o.type == "LIGHT"]:
        bpy.data.objects.remove(thing)  # its reader turns lumens into watts
    if lamp:
        blender_lamp(*lamp)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples = "CPU", int(samples)
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_indirect = cycles.sample_clamp_direct = cycles.light_sampling_threshold = cycles.blur_glossy = 0.0
    cycles.max_bounces = cycles.diffuse_bounces = bounces
    cycles.glossy_bounces = cycles.transmission_bounces = 0
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    nodes = scene.world.node_tree
    if sky:
        texture = nodes.nodes.new("ShaderNodeTexEnvironment")
        texture.image = bpy.data.images.load(sky)
        nodes.links.new(texture.outputs["Color"], nodes.nodes["Background"].inputs["Color"])
    else:
        nodes.nodes["Background"].inputs["Color"].default_value = (0, 0, 0, 1)
    image = bpy.data.images.new("lightmap", SIZE, SIZE, float_buffer=True, is_data=True)
    room, = [o for o in scene.objects if o.type == "MESH"]
    for material in room.data.materials:  # diffuse, and nothing else
        name = material.name.split(".")[0]
        material.use_nodes = True
        tree = material.node_tree
        tree.nodes.clear()
        diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
        diffuse.inputs["Color"].default_value = (*ALBEDO[name], 1.0)
        shader = diffuse.outputs[0]
        if name == "panel" and emits:  # from its front alone
            emission, facing, add = (tree.nodes.new(f"ShaderNode{kind}") for kind in ("Emission", "NewGeometry", "AddShader"))
            scale = tree.nodes.new("ShaderNodeMath")
            scale.operation = "MULTIPLY_ADD"
            tree.links.new(facing.outputs["Backfacing"], scale.inputs[0])
            scale.inputs[1].default_value, scale.inputs[2].default_value = -PANEL_RADIANCE, PANEL_RADIANCE
            tree.links.new(scale.outputs[0], emission.inputs["Strength"])
            tree.links.new(shader, add.inputs[0])
            tree.links.new(emission.outputs[0], add.inputs[1])
            shader = add.outputs[0]
        tree.links.new(shader, tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
        target = tree.nodes.new("ShaderNodeTexImage")
        target.image = image
        tree.nodes.active = target
    room.data.uv_layers.active_index = 1
    room.select_set(True)
    bpy.context.view_layer.objects.active = room
    maps = []
    for seed in seeds:
        cycles.seed = seed
        bpy.ops.object.bake(type="DIFFUSE", pass_filter={"DIRECT", "INDIRECT"} if bounces else {"DIRECT"}, margin=0)
        maps.append(pixels(image)[..., :3])
    return maps


BLACK = ["--sky", "0,0,0"]
SKY = work.name + "/sky.hdr"
write_sky(SKY)
lamp = lambda kind, intensity, **more: {"type": kind, "intensity": intensity, **more}
soft = lambda **size: {"extras": {"vkbake": size}}
CANDELA = 4.0 * math.pi  # watts of Blender's lamps of 1 W/sr
CASES = [  # name, lamp of ours (at, to, definition), lamp of theirs, sky, the panel emits, bounces of theirs, flags of ours
    ("sky's picture", None, None, SKY, False, 0, ["--sky", SKY]),
    ("sun, 2° wide", ((0, 0, 0), SUN_TO, lamp("directional", 3.0, **soft(angularDiameter=2.0))),
     ("SUN", (0, 0, 0), SUN_TO, 3.0, math.radians(2.0)), None, False, 0, BLACK),
    ("point lamp, 10 cm", (LAMP_AT, (0, -1, 0), lamp("point", 6.0, **soft(radius=0.1))),
     ("POINT", LAMP_AT, (0, -1, 0), 6.0 * CANDELA, 0.1), None, False, 0, BLACK),
    # Hard, as its disc is no sphere. Theirs sends by the cosine to its axis besides, which is given back below.
    ("spotlight", (LAMP_AT, tuple(b - a for a, b in zip(LAMP_AT, SPOT_TO)),
                         lamp("spot", 9.0, spot={"innerConeAngle": 0.4995, "outerConeAngle": 0.5})),
     ("SPOT", LAMP_AT, tuple(b - a for a, b in zip(LAMP_AT, SPOT_TO)), 9.0 * CANDELA, 0.0, 0.5), None, False, 0, BLACK),
    ("emitting panel", None, None, None, True, 0, [*BLACK, "--bounces", "1"]),
    ("sky, 4 bounces", None, None, SKY, False, 4, ["--sky", SKY, "--bounces", "4"]),
]
# Texels that a chart covers whole, the panel's back and what the box stands on aside.
covered = numpy.zeros((SIZE, SIZE), dtype=bool)
for name, quads in FACES.items():
    for _, uvs, _ in quads:
        x, y = round(uvs[3][0] * SIZE), round(uvs[3][1] * SIZE)
        covered[y:round(uvs[0][1] * SIZE), x:round(uvs[1][0] * SIZE)] = True



def spot_cosines():
    """Of each texel's centre, to the spotlight's axis."""
    cosines = numpy.ones((SIZE, SIZE))
    axis = numpy.array(SPOT_TO) - LAMP_AT
    for quads in FACES.values():
        for corners, uvs, _ in quads:
            left, top = round(uvs[3][0] * SIZE), round(uvs[3][1] * SIZE)
            width, height = round(uvs[1][0] * SIZE) - left, round(uvs[0][1] * SIZE) - top
            for y in range(height):
                for x in range(width):
                    across, up = (x + 0.5) / width, 1.0 - (y + 0.5) / height
                    way = corners[0] + across * (corners[1] - corners[0]) + up * (corners[3] - corners[0]) - LAMP_AT
                    cosines[top + y, left + x] = way @ axis / numpy.linalg.norm(way) / numpy.linalg.norm(axis)
    return cosines[covered][:, None]


print("| light | mean, ours / theirs − 1 | difference of texels | noise, ours | noise, theirs | half of the texels differ by less than |")
print("|---|---|---|---|---|---|")
for name, our_lamp, their_lamp, sky, emits, bounces, flags in CASES:
    file = work.name + "/scene.glb"
    write_scene(file, our_lamp, emits)
    their_maps = [m[covered] for m in theirs(file, sky, their_lamp, emits, bounces, (1, 2))]
    if name == "spotlight":
        their_maps = [m / spot_cosines() for m in their_maps]
    our_maps = [ours(file, flags, seed)[covered] for seed in (1, 2)]
    mean = numpy.mean(their_maps)
    rms = lambda values: 100.0 * math.sqrt(numpy.mean(values ** 2)) / mean
    difference = (our_maps[0] + our_maps[1] - their_maps[0] - their_maps[1]) / 2
    noise = [rms(maps[0] - maps[1]) / 2 for maps in (our_maps, their_maps)]  # of the mean of both seeds
    print(f"| {name} | {100 * (numpy.mean(our_maps) / mean - 1):+.2f} % | {rms(difference):.2f} % | {noise[0]:.2f} % | "
          f"{noise[1]:.2f} % | {100 * numpy.median(numpy.abs(difference)) / mean:.2f} % |", flush=True)
