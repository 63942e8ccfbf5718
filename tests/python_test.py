#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The module candela.ri: what its calls write as RIB, what they say of bad arguments and scenes, the
pictures that come back. The example in Python has the picture, and the RIB, of the one in C.

usage: python_test.py BUILD_FOLDER SOURCE_FOLDER
"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import numpy

BUILD, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
sys.path.insert(0, str(BUILD / "lib/python"))
from candela import ri  # noqa: E402 (it lies in the build folder)

ROWS = numpy.arange(12, dtype=numpy.float32).reshape(4, 3)
ROW_TEXT = "[0 1 2 3 4 5 6 7 8 9 10 11]"

# Calls, and the RIB that they are.
CALLS = [
    (lambda: ri.Sphere(1, -1, 1, 360), "Sphere 1 -1 1 360"),
    (lambda: ri.Sphere(radius=1, zMin=-1, zMax=1, thetaMax=360), "Sphere 1 -1 1 360"),
    (lambda: ri.Sphere(1, -1, zMax=1, thetaMax=360, Cs=[1, 0, 0]), 'Sphere 1 -1 1 360 "Cs" [1 0 0]'),
    (lambda: ri.Sphere(1, -1, 1, 360, {"Cs": [1, 0, 0]}), 'Sphere 1 -1 1 360 "Cs" [1 0 0]'),
    (lambda: ri.Sphere(1, -1, 1, 360, "Cs", [1, 0, 0]), 'Sphere 1 -1 1 360 "Cs" [1 0 0]'),
    (lambda: ri.Color(1, .5, 0), "Color [1 0.5 0]"),
    (lambda: ri.Color((1, .5, 0)), "Color [1 0.5 0]"),
    (lambda: ri.Color(numpy.array([1, .5, 0])), "Color [1 0.5 0]"),
    (lambda: ri.Hyperboloid([1, 2, 3], [4, 5, 6], 360), "Hyperboloid 1 2 3 4 5 6 360"),
    (lambda: ri.Bound([0, 1, 2, 3, 4, 5]), "Bound 0 1 2 3 4 5"),
    (lambda: ri.Transform(numpy.identity(4)), "Transform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]"),
    (lambda: ri.ConcatTransform([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [1, 2, 3, 1]]),
     "ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1]"),
    (lambda: ri.Basis("b-spline", 1, range(16), 2),
     'Basis "b-spline" 1 [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15] 2'),
    (lambda: ri.Format(640, numpy.int64(480), 1), "Format 640 480 1"),
    (lambda: ri.Matte(True), "Matte 1"),
    (lambda: ri.MotionBegin(0, .5), "MotionBegin [0 0.5]"),
    (lambda: ri.MotionBegin([0, .5]), "MotionBegin [0 0.5]"),
    (lambda: ri.DepthOfField(), "DepthOfField"),
    (lambda: ri.Surface("plastic", Kd=.5, texturename="wood.tx"),
     'Surface "plastic" "Kd" [0.5] "texturename" ["wood.tx"]'),
    (lambda: ri.Attribute("user", {"integer ids[2]": [16777217, -3]}),
     'Attribute "user" "integer ids[2]" [16777217 -3]'),
    (lambda: ri.Attribute("user", {"string moods[2]": ["calm", "wild"]}),
     'Attribute "user" "string moods[2]" ["calm" "wild"]'),
    # Arrays of every kind and shape are their numbers, row by row.
    (lambda: ri.Polygon(P=ROWS), f'Polygon "P" {ROW_TEXT}'),
    (lambda: ri.Polygon(P=ROWS.astype(float)), f'Polygon "P" {ROW_TEXT}'),
    (lambda: ri.Polygon(P=ROWS.astype(numpy.int16)), f'Polygon "P" {ROW_TEXT}'),
    (lambda: ri.Polygon(P=numpy.asfortranarray(ROWS)), f'Polygon "P" {ROW_TEXT}'),
    (lambda: ri.Polygon(P=numpy.repeat(ROWS, 2, axis=0)[::2]), f'Polygon "P" {ROW_TEXT}'),
    (lambda: ri.Polygon(P=ROWS.tolist()), f'Polygon "P" {ROW_TEXT}'),
    (lambda: ri.PointsPolygons([3, 3], numpy.array([0, 1, 2, 1, 2, 3], numpy.int32), P=ROWS),
     f'PointsPolygons [3 3] [0 1 2 1 2 3] "P" {ROW_TEXT}'),
    (lambda: ri.PointsPolygons((3, 3), numpy.array([[0, 1, 2], [1, 2, 3]]), P=ROWS),
     f'PointsPolygons [3 3] [0 1 2 1 2 3] "P" {ROW_TEXT}'),
    (lambda: ri.SubdivisionMesh("catmull-clark", [4], range(4), P=ROWS),
     f'SubdivisionMesh "catmull-clark" [4] [0 1 2 3] "P" {ROW_TEXT}'),
    (lambda: ri.SubdivisionMesh("catmull-clark", [4], range(4), ["crease"], [2, 1], [0, 1], [3],
                                {"P": ROWS}),
     f'SubdivisionMesh "catmull-clark" [4] [0 1 2 3] ["crease"] [2 1] [0 1] [3] "P" {ROW_TEXT}'),
    (lambda: ri.Procedural("DelayedReadArchive", ["a.rib"], [0, 1, 0, 1, 0, 1]),
     'Procedural "DelayedReadArchive" ["a.rib"] [0 1 0 1 0 1]'),
    (lambda: ri.Illuminate(ri.LightSource("ambientlight", intensity=.5), False),
     'LightSource "ambientlight" 1 "intensity" [0.5]\nIlluminate 1 0'),
    (lambda: ri.Illuminate(ri.LightSource("ambientlight", handle="sky"), True),
     'LightSource "ambientlight" "sky"\nIlluminate "sky" 1'),
    (lambda: (ri.ObjectBegin(), ri.ObjectEnd(), ri.ObjectInstance(1)),
     "ObjectBegin 1\nObjectEnd\nObjectInstance 1"),
    (lambda: ri.Bxdf("PxrDiffuse", "skin", {}), 'Bxdf "PxrDiffuse" "skin"'),
    (lambda: (ri.ArchiveRecord("comment", "hi"), ri.ArchiveRecord("structure", "Scene"),
              ri.ArchiveRecord("verbatim", "Sides 1\n")), "# hi\n##Scene\nSides 1"),
    (lambda: ri.Declare("tint", "uniform color"), 'Declare "tint" "uniform color"'),
]

# Calls that are none, and what is said.
NO_CALLS = [
    (lambda: ri.Sphere(1, -1, 1), "Sphere: the argument 'thetaMax' is missing"),
    (lambda: ri.Sphere("1", -1, 1, 360), "Sphere: expected a number for 'radius', not 'str'"),
    (lambda: ri.Sphere(None, -1, 1, 360), "Sphere: expected a number for 'radius', not 'NoneType'"),
    (lambda: ri.Sphere([], -1, 1, 360), "Sphere: expected a number for 'radius', not 'list'"),
    (lambda: ri.Translate(1, 2, 3, 4), "Translate: there are too many arguments"),
    (lambda: ri.Color([1, 2, 3, 4]), "Color: there are too many arguments"),
    (lambda: ri.Translate(1, 2, 3, dw=4), "Translate: it has no argument 'dw'"),
    (lambda: ri.Format(640.5, 480, 1), "Format: expected a whole number for 'xResolution'"),
    (lambda: ri.Surface(3), "Surface: expected a string for 'name', not 'int'"),
    (lambda: ri.Surface("plastic", Kd=None), "Surface: expected numbers or strings for 'Kd'"),
    (lambda: ri.Surface("plastic", "Kd"), "Surface: the value of 'Kd' is missing"),
    (lambda: ri.Surface("plastic", 3), "Surface: expected a dictionary"),
    (lambda: ri.Polygon(P=[[1, 2], [3]]), "Polygon: expected numbers or strings for 'P'"),
    (lambda: ri.Polygon(P=["a", 1]), "Polygon: expected numbers or strings for 'P'"),
    (lambda: ri.Polygon(P=object()), "Polygon: expected numbers or strings for 'P'"),
    (lambda: ri.PointsPolygons([3.5], [0, 1, 2]),
     "PointsPolygons: expected whole numbers for 'vertexCounts', not 'list'"),
    (lambda: ri.PointsPolygons([2**40], [0, 1, 2]), "PointsPolygons: expected whole numbers"),
    (lambda: ri.Illuminate(1.5, True), "Illuminate: expected a handle for 'light', not 'float'"),
]


def run(*words, **how):
    done = subprocess.run(words, capture_output=True, text=True, check=False, **how)
    assert done.returncode == 0 and not done.stderr, (words, done.stdout, done.stderr)
    return done.stdout


class Scratch(unittest.TestCase):
    """In a folder of its own; warnings are errors."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        warnings.simplefilter("error")


class Calls(Scratch):
    @staticmethod
    def rib_of(calls):
        ri.Begin("x.rib")
        try:
            calls()
        finally:
            ri.End()
        return re.sub(r"\s+", " ", pathlib.Path("x.rib").read_text().split("\n", 1)[1]).strip()

    def test_calls_are_requests(self):
        for call, rib in CALLS:
            with self.subTest(rib):
                self.assertEqual(self.rib_of(call), rib.replace("\n", " "))

    def test_what_is_no_call_says_why_and_does_nothing(self):
        for call, message in NO_CALLS:
            with self.subTest(message):
                def attempt():
                    with self.assertRaises((TypeError, ValueError)) as caught:
                        call()
                    self.assertIn(message, str(caught.exception))
                self.assertEqual(self.rib_of(attempt), "")

    def test_every_request_has_its_call_and_its_help(self):
        self.assertIn("Sphere(radius, zMin, zMax, thetaMax, ...)", ri.Sphere.__doc__)
        names = [name for name in dir(ri) if name[0].isupper()]
        self.assertGreater(len(names), 130)
        self.assertNotIn("handle", ri.LightSource.__doc__.split("\n")[0])

    def test_begin_and_end_belong_together(self):
        for call in (ri.End, lambda: ri.Sides(1)):
            with self.assertRaisesRegex(ValueError, "Begin comes first"):
                call()
        with self.assertRaisesRegex(OSError, "'none/x.rib' cannot be written"):
            ri.Begin("none/x.rib")
        ri.Begin("x.rib")
        with self.assertRaisesRegex(ValueError, "End comes first"):
            ri.Begin("y.rib")
        ri.End()

    def test_files_may_be_packed(self):
        ri.Begin("x.rib.gz")
        ri.Sides(1)
        ri.End()
        self.assertEqual(pathlib.Path("x.rib.gz").read_bytes()[:2], b"\x1f\x8b")


class Renders(Scratch):
    @staticmethod
    def world(displays=("seen",), mode="rgba", size=(8, 6)):
        """A disk of albedo 1 in light of 1 fills all of the picture but its right half."""
        for number, name in enumerate(displays):
            ri.Display(("+" if number else "") + name, "array", mode)
        ri.Format(*size, 1)
        ri.PixelSamples(1, 1)
        ri.PixelFilter("box", 1, 1)
        ri.WorldBegin()
        ri.LightSource("ambientlight")
        ri.Surface("constant")
        ri.Color(1, .5, .25)
        ri.Polygon(P=[[-9, -9, 1], [0, -9, 1], [0, 9, 1], [-9, 9, 1]])
        ri.WorldEnd()

    def test_pictures_come_back_as_arrays(self):
        ri.Begin()
        self.world(mode="rgba,z,N")
        ri.End()
        picture = ri.picture("seen")
        self.assertEqual(picture.pixels.shape, (6, 8, 8))
        self.assertEqual(picture.pixels.dtype, numpy.float32)
        self.assertEqual(picture.channels, ["R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z"])
        self.assertEqual(picture.pixels[3, 1, :5].round(6).tolist(), [1, .5, .25, 1, 1])
        self.assertEqual(picture.pixels[3, 6, :4].tolist(), [0, 0, 0, 0])
        self.assertEqual(picture["G"].shape, (6, 8))
        self.assertEqual(picture["N"].shape, (6, 8, 3))
        self.assertTrue(numpy.shares_memory(picture["N"], picture.pixels))
        self.assertEqual(numpy.asarray(picture).sum(), picture.pixels.sum())
        self.assertEqual(picture.metadata["units"], "relative")
        with self.assertRaisesRegex(KeyError, "no channel 'albedo'; it has R, G, B, A, Z"):
            picture["albedo"]
        self.assertEqual(os.listdir("."), [])

    def test_pictures_have_names(self):
        ri.Begin()
        self.world(("one", "two"))
        ri.End()
        self.assertEqual(ri.picture("one").pixels.tolist(), ri.picture("two").pixels.tolist())
        with self.assertRaisesRegex(KeyError, "needs a name.*one, two"):
            ri.picture()
        with self.assertRaisesRegex(KeyError, "no picture .+three.*one, two"):
            ri.picture("three")
        ri.Begin()
        self.world(("last",))
        ri.End()
        self.assertEqual(ri.picture().pixels.shape, (6, 8, 4))
        with self.assertRaises(KeyError):
            ri.picture("one")

    def test_arrays_are_what_files_are(self):
        ri.Begin()
        ri.Display("file.exr", "openexr", "rgba")
        self.world(("+seen",), size=(30, 20))
        ri.End()
        self.assertEqual(ri.picture("seen").pixels.shape, (20, 30, 4))
        run(BUILD / "bin/candela", "diff", "file.exr", "file.exr")

    def test_what_is_wrong_with_a_scene_is_raised(self):
        ri.Begin()
        with self.assertRaisesRegex(ri.Error, "Sides"):
            ri.Sides(7)
        with self.assertRaisesRegex(ri.Warning, "Camera"):
            ri.Camera("of later RenderMan")
        with self.assertRaisesRegex(ri.Error, "WorldEnd without WorldBegin"):
            ri.WorldEnd()
        with self.assertRaisesRegex(ri.Error, "ArchiveRecord: 'secret' is unknown"):
            ri.ArchiveRecord("secret", "x")
        self.world()
        ri.End()
        self.assertEqual(ri.picture().pixels.shape, (6, 8, 4))

    def test_messages_name_the_line_of_the_call(self):
        ri.Begin()
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            ri.Camera("of later RenderMan")
        ri.Hider("null")
        self.world()
        ri.End()
        self.assertEqual(pathlib.Path(caught[0].filename).name, "python_test.py")


class Interrupts(Scratch):
    PROGRAM = """
from candela import ri
ri.Begin()
ri.Display("seen", "array", "rgba")
ri.Format(64, 48, 1)
ri.PixelSamples(4096, 256)
ri.WorldBegin()
ri.LightSource("pointlight")
ri.Translate(0, 0, 2)
ri.Sphere(1, -1, 1, 360)
print("now", flush=True)
try:
    ri.WorldEnd()
except KeyboardInterrupt:
    ri.End()
    print(ri.picture("seen").pixels.max() > 0)
"""

    def test_ctrl_c_ends_a_render_with_the_samples_that_there_are(self):
        environment = dict(os.environ, PYTHONPATH=str(BUILD / "lib/python"))
        child = subprocess.Popen([sys.executable, "-c", self.PROGRAM], env=environment, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(child.stdout.readline(), "now\n")
        time.sleep(3)
        child.send_signal(signal.SIGINT)
        said, complained = child.communicate(timeout=100)
        self.assertEqual(said, "True\n", complained)
        self.assertIn("interrupted after", complained)


class Example(Scratch):
    def test_it_is_the_example_in_c(self):
        environment = dict(os.environ, PYTHONPATH=str(BUILD / "lib/python"))
        example = SOURCE / "examples/python/balls.py"
        candela = BUILD / "bin/candela"
        run(BUILD / "bin/balls")
        run(BUILD / "bin/balls", "c.rib")
        os.rename("balls.exr", "c.exr")
        said = run(sys.executable, example, env=environment)
        self.assertRegex(said, r"^brightest at column \d+, row \d+: \d\.\d\d m away\n$")
        run(candela, "diff", "balls.exr", "c.exr")
        run(sys.executable, example, "python.rib", env=environment)
        self.assertEqual(pathlib.Path("python.rib").read_text(), pathlib.Path("c.rib").read_text())
        os.remove("balls.exr")
        run(candela, "--quiet", "python.rib")
        run(candela, "diff", "balls.exr", "c.exr")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
