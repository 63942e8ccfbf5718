# SPDX-License-Identifier: Apache-2.0
"""Width: thousands of one request, and whatever grows with pairs of them."""
from attacks.attack import HEAD, WORLD, Attempt, attack, counted, filled, scene

SPHERE = "Sphere 1 -1 1 360 "
AWAY = "Translate 0 0 5\n"


def requests(name, unit, after="", options="", before=AWAY, quick=False):
    """A scene with thousands of a request, each with its number."""
    attack(lambda size, chance: scene(before + counted(size, unit) + after, options), quick=quick, name=name)


def options_of(name, unit, quick=False):
    """Thousands of an option before the world."""
    attack(lambda size, chance: scene(AWAY + SPHERE, counted(size, unit)), quick=quick, name=name)


requests("lights", 'LightSource "pointlight" {}\n', SPHERE)
requests("lights-by-shadows", 'LightSource "spotlight" "l{0}" "from" [{0} 0 0]\n', SPHERE,
         options='Option "render" "string integrator" ["path"]\n')
requests("lights-switched", 'LightSource "pointlight" {0} Illuminate {0} 0 Sphere 1 -1 1 9\n')
requests("area-lights", 'AttributeBegin AreaLightSource "arealight" {0} Sphere .1 -.1 .1 360 AttributeEnd\n', SPHERE)
requests("area-lights-of-many", "Sphere .1 -.1 .1 360\n", before=AWAY + 'AreaLightSource "arealight" 9\n')
requests("coordinate-systems", 'CoordinateSystem "c{}"\n', SPHERE)
requests("colours", "Color [{0} .1 .2] Sphere 1 -1 1 9\n")
requests("user-attributes", 'Attribute "user" "float a{}" [1]\n', SPHERE)
requests("user-attributes-each", 'Attribute "user" "float a{}" [1] Sphere 1 -1 1 9\n')
requests("declarations", 'Declare "d{}" "uniform float[9]"\n', SPHERE, quick=True)
requests("objects", "ObjectBegin {} Sphere 1 -1 1 360 ObjectEnd\n", "ObjectInstance 5")
requests("instances", "Translate .01 0 0 ObjectInstance 1\n", before="ObjectBegin 1 Sphere 1 -1 1 360 ObjectEnd\n")
requests("solids-side-by-side", 'SolidBegin "primitive" Sphere 1 -1 1 360 SolidEnd\n')
requests("solids-in-one", 'SolidBegin "primitive" Sphere 1 -1 1 360 SolidEnd\n', "SolidEnd",
         before=AWAY + 'SolidBegin "union"\n')
requests("solids-cut-away", 'SolidBegin "primitive" Translate .01 0 0 Torus 1 .4 0 360 360 SolidEnd\n', "SolidEnd",
         before=AWAY + 'SolidBegin "difference"\n')
requests("surfaces-by-strings", 'Surface "paintedplastic" "string texturename" ["t{}"] Sphere 1 -1 1 9\n')
requests("surfaces-by-numbers", 'Surface "plastic" "float roughness" [.{}] Sphere 1 -1 1 9\n')
requests("surfaces-missing", 'Surface "nosuch{}" Sphere 1 -1 1 9\n')
requests("volumes", 'Interior "fog" "float distance" [{}] Sphere 1 -1 1 360\n')
requests("displacements", 'Displacement "bumpy" "float Amplitude" [.{}] Sphere 1 -1 1 360\n')
requests("blocks-empty", "AttributeBegin AttributeEnd\n")
requests("clipping-planes", "ClippingPlane 0 0 {} 0 0 1\n", SPHERE, quick=True)
requests("details", "Detail [0 1 0 1 0 1] DetailRange 0 {} 900 1000 Sphere 1 -1 1 9\n")
requests("resources", 'Resource "r{}" "attributes" "string operation" ["save"]\n', SPHERE)
requests("motions", "MotionBegin [0 1] Translate 0 0 0 Translate {} 0 0 MotionEnd\n", SPHERE,
         options="Shutter 0 1\n")
requests("whole-spheres", SPHERE, quick=True)
requests("teapots", 'Geometry "teapot"\n')
requests("fine-spheres", "Sphere 1 -1 .99 360\n", before=AWAY + "ShadingRate .001\n")
options_of("displays", 'Display "+d{}.exr" "openexr" "rgba"\n')
options_of("displays-of-one-file", 'Display "+same.exr" "openexr" "rgba"\n')
options_of("display-channels", 'DisplayChannel "varying float c{}"\n')
options_of("formats", "Format 16 16 {}\n", quick=True)
options_of("user-options", 'Option "user" "float a{}" [1]\n')
options_of("imagers", 'Imager "background" "color bgcolor" [{} 0 0]\n')
options_of("filters", 'PushFilter "bloom"\n')
options_of("cropwindows", "CropWindow 0 1 0 1\n")
options_of("textures-made", 'MakeTexture "nosuch{}" "b{}" "periodic" "clamp" "box" 1 1\n'.replace("b{}", "b"))


@attack
def display_of_many_channels(size, chance):
    channels = ",".join(f"c{i}" for i in range(size // 8))
    return scene(AWAY + SPHERE, f'Display "+many.exr" "openexr" "{channels}"\n')


@attack
def display_of_one_channel_often(size, chance):
    return scene(AWAY + SPHERE, 'Display "+many.exr" "openexr" "' + filled(size, "N,") + 'z"\n')


@attack
def parameters(size, chance):
    return scene(AWAY + 'Surface "plastic" ' + counted(size, '"uniform float p{}" [1]\n') + SPHERE)


@attack
def parameter_often(size, chance):
    return scene(AWAY + 'Surface "plastic" ' + filled(size, '"Kd" [1]\n') + SPHERE)


@attack
def primitive_variables(size, chance):
    return scene(AWAY + SPHERE + counted(size, '"uniform float p{}" [1]\n'))


@attack
def primitive_variables_read(size, chance):
    values = counted(size, '"uniform float p{}" [1]\n')
    return scene(AWAY + 'Surface "matte" ' + 'Polygon "P" [0 0 0 1 0 0 0 1 0] ' + values)


@attack
def motion_times(size, chance):
    count = size // 24
    times = " ".join(str(i) for i in range(count))
    moves = counted(count * 19, "Translate {} 0 0\n")
    return scene(f"{AWAY}MotionBegin [{times}] {moves} MotionEnd {SPHERE}", "Shutter 0 1\n")


@attack
def motion_of_shapes(size, chance):
    count = size // 60
    times = " ".join(str(i) for i in range(count))
    shapes = filled(count * 48, 'Patch "bilinear" "P" [0 0 0 1 0 0 0 1 0 1 1 0]\n')
    return scene(f"{AWAY}MotionBegin [{times}] {shapes} MotionEnd", "Shutter 0 1\n")


@attack
def motion_of_times_in_blocks(size, chance):
    """Forty blocks of a hundred times: one transformation of as many as their union."""
    text = ""
    for i in range(40):
        times = " ".join(f"{j + i / 40:g}" for j in range(100))
        text += f"MotionBegin [{times}] " + "Rotate 9 0 0 1 " * 100 + "MotionEnd\n"
    return scene(text[:size] + SPHERE, "Shutter 0 100\n")


@attack
def frames(size, chance):
    return Attempt({"scene.rib": HEAD + counted(size, f"FrameBegin {{}} {WORLD} WorldEnd FrameEnd\n")})


@attack
def search_path_entries(size, chance):
    """Each of many names is looked for in each of many folders."""
    folders = ":".join(f"d{i}" for i in range(size // 2 // 6))
    path = f'Option "searchpath" "string shader" ["{folders}"] "string texture" ["{folders}"]\n'
    return scene(AWAY + counted(size // 2, 'Surface "s{}" Sphere 1 -1 1 9\n'), path)


@attack
def search_path_of_archives(size, chance):
    folders = ":".join(f"d{i}" for i in range(size // 2 // 6))
    path = f'Option "searchpath" "string archive" ["{folders}"]\n'
    return scene(counted(size // 2, 'ReadArchive "a{}"\n'), path)


@attack
def search_path_of_itself(size, chance):
    """& is the path as it was: it doubles."""
    return scene(AWAY + SPHERE, filled(size, 'Option "searchpath" "string shader" ["&:&"]\n'))


@attack
def shaders_each_another(size, chance):
    """As many small shaders as there is room for, each used once."""
    unit = "surface s{0}() {{ Ci = {0}; Oi = 1; }}\n"
    count = size // 90
    made = scene(AWAY + "".join(f'Surface "s{i}" Sphere 1 -1 1 9\n' for i in range(count)))
    made.files |= {f"s{i}.sl": unit.format(i) for i in range(count)}
    return made
