# SPDX-License-Identifier: Apache-2.0
"""Settings at the ends of what numbers can say."""
from attacks.attack import HEAD, RENDER, WORLD, Attempt, attack, filled, scene, shaded

SPHERE = "Translate 0 0 5 Sphere 1 -1 1 360"
OPTIONS = {  # What ends soon: nothing here asks for more work than a small picture.
    "crop-of-nothing": "CropWindow .5 .5 .5 .5\n",
    "crop-turned-round": "CropWindow 1 0 1 0\n",
    "crop-of-no-numbers": "CropWindow nan inf -inf 1e400\n",
    "format-of-nothing": "Format 0 0 0\n",
    "format-below-nothing": "Format -2147483648 -1 1e-38\n",
    "format-beyond-integers": "Format 1e20 1e20 1e20\n",
    "format-of-an-exabyte": "Format 1000000000 1000000000 1\n",
    "format-of-a-terabyte": "Format 300000 300000 1\n",
    "format-one-row": "Format 2000000000 1 1\n",
    "format-one-column": "Format 1 2000000000 1\n",
    "aspect-huge": "Format 16 16 1e30\nFrameAspectRatio 1e30\n",
    "screen-window-huge": "ScreenWindow -1e38 1e38 -1e38 1e38\n",
    "screen-window-of-nothing": "ScreenWindow 0 0 0 0\n",
    "clipping-of-nothing": "Clipping 0 0\n",
    "clipping-turned-round": "Clipping 1e38 -1e38\n",
    "shutter-for-ever": "Shutter -1e38 1e38\n",
    "focus-on-nothing": "DepthOfField 0 0 0\n",
    "focus-huge": "DepthOfField 1e-38 1e38 1e38\n",
    "filter-wide": 'PixelFilter "gaussian" 1e9 1e9\n',
    "filter-wide-as-the-picture": 'PixelFilter "sinc" 1000 1000\n',
    "exposure-huge": "Exposure 1e38 1e-38\n",
    "quantize-huge": 'Quantize "rgba" 2147483647 -2147483648 2147483647 1e38\n',
    "depth-of-paths": 'Option "trace" "integer maxdepth" [2147483647]\n'
                      'Option "render" "string integrator" ["path"]\n',
    "colour-samples": "ColorSamples [" + "1 " * 3000 + "] [" + "1 " * 3000 + "]\n",
    "fov-of-everything": 'Projection "perspective" "fov" [179.9999999]\n',
    "fov-of-nothing": 'Projection "perspective" "fov" [0]\n',
    "camera-beyond": "Translate 1e38 1e38 1e38 Translate 1e38 1e38 1e38\n",
}
for name, option in OPTIONS.items():
    attack(lambda size, chance, option=option: scene(SPHERE, option), name=name,
           quick=name in ("format-of-an-exabyte", "crop-of-no-numbers", "filter-wide"))

ASKED = {  # What asks for more work than it is worth: --spp and --format say how much is given.
    "samples-asked": ("PixelSamples 1000000000 1000000000\n", ["--spp", "1"]),
    "pixels-asked": ("Format 1000000 1000000 1\n", ["--format", "16x16"]),
    "bidir-asked": ('Option "render" "string integrator" ["bidir"]\n', []),
    "vcm-asked": ('Option "render" "string integrator" ["vcm"]\n', []),
    "radiosity-asked": ('Option "render" "string integrator" ["radiosity"]\n', []),
}
for name, (option, words) in ASKED.items():
    attack(lambda size, chance, option=option, words=words: scene(SPHERE, option, words), name=name)


def integrated(integrator, requests):
    option = f'Option "render" "string integrator" ["{integrator}"]\n' \
             'Option "trace" "integer maxdepth" [64]\n'
    return scene('AttributeBegin AreaLightSource "arealight" 9 Translate 0 3 5 Rotate 90 1 0 0 Disk 0 1 360 '
                 "AttributeEnd\nTranslate 0 0 5\n" + requests, option)


for integrator in ("path", "bidir", "vcm", "radiosity", "classic"):
    attack(lambda size, chance, integrator=integrator: integrated(
        integrator, filled(size, "Sphere 1 -1 1 360 Scale .999 1 1\n")), name=f"shells-by-{integrator}")
    attack(lambda size, chance, integrator=integrator: integrated(
        integrator, 'Surface "glass"\n' + filled(size, "Sphere 1 -1 1 360 Scale .999 .999 .999\n")),
           name=f"glass-shells-by-{integrator}")
    attack(lambda size, chance, integrator=integrator: integrated(
        integrator, "Opacity .01 .01 .01\n" + filled(size, "Sphere 1 -1 1 360 Scale .999 .999 .999\n")),
           name=f"clear-shells-by-{integrator}")


@attack
def mirrors_facing(size, chance):
    """Two mirrors and whatever lies between them."""
    walls = 'Surface "mirror"\nPolygon "P" [-9 -1 0 9 -1 0 9 -1 9 -9 -1 9] Polygon "P" [-9 1 0 9 1 0 9 1 9 -9 1 9]\n'
    return scene(walls + "Translate 0 0 5 " + filled(size, "Sphere .1 -.1 .1 360 Translate .01 0 0\n"),
                 'Option "trace" "integer maxdepth" [1000000]\n')


@attack
def checkpoint_each_moment(size, chance):
    made = scene("Translate 0 0 5 " + filled(size, "Sphere 1 -1 1 360\n"))
    return Attempt(made.files, [*RENDER, "--checkpoint", "c", "--every", ".01"])


def displaced(amount, bound, body, rate="1"):
    source = f"displacement attack() {{ {body} P += {amount} * N; N = calculatenormal(P); }}\n"
    return shaded(source, requests=f'Attribute "displacementbound" "sphere" [{bound}] ShadingRate {rate}')


DISPLACED = {
    "displaced-beyond": ("1e38", "1e38", ""),
    "displaced-by-no-number": ("0 / 0", "1", ""),
    "displaced-by-noise": ("noise(P * 1e9) * 100", "100", ""),
    "displaced-without-bound": ("1000", "0", ""),
    "displaced-by-a-loop": ("h", "1", "float h = 0, i; for (i = 0; i < 10000; i += 1) h += noise(P * i) / 1e4;"),
}
for name, (amount, bound, body) in DISPLACED.items():
    attack(lambda size, chance, a=amount, b=bound, c=body: displaced(a, b, c), name=name)


@attack
def displaced_finely(size, chance):
    return displaced("noise(P * 1e5)", "1", "", rate="1e-9")


@attack
def displaced_by_the_thousand(size, chance):
    made = displaced("noise(P * 100)", "1", "")
    made.files["scene.rib"] = made.files["scene.rib"].replace(
        "Sphere 1.4 -1.4 1.4 360", filled(size, "Sphere 1.4 -1.4 1.4 360 Translate .01 0 0\n"))
    return made


@attack
def worlds_without_end(size, chance):
    """A world that is never closed, again and again."""
    return Attempt({"scene.rib": HEAD + filled(size, WORLD)})
