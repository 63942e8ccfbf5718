// SPDX-License-Identifier: Apache-2.0
#include "scenes/description.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace candela::bench {
namespace {

/// Text with as many digits as a float needs to come back the same.
class RibFile {
public:
    explicit RibFile(const std::string &name)
        : name_(name), file_(std::fopen(name.c_str(), "w"), &std::fclose) {
        if (!file_)
            throw std::runtime_error("cannot write " + name);
    }
    void text(const char *words) { std::fputs(words, file_.get()); }
    void number(float value) { std::fprintf(file_.get(), "%.9g ", double(value)); }
    void point(Vec3 p) { number(p.x), number(p.y), number(p.z); }
    template <class... Values> void line(const char *format, Values... values) {
        std::fprintf(file_.get(), format, values...);
    }
    void finish() {
        if (std::fflush(file_.get()) != 0 || std::ferror(file_.get()))
            throw std::runtime_error("cannot write " + name_);
    }

private:
    std::string name_;
    std::unique_ptr<std::FILE, int (*)(std::FILE *)> file_;
};

void writeCamera(RibFile &rib, const SceneDescription &scene) {
    double degrees = 2 * std::atan(double(scene.halfExtent)) * 180 / std::numbers::pi;
    rib.text("##RenderMan RIB-Structure 1.1\nOption \"radiometry\" \"string units\" \"si\"\n"
             "Option \"trace\" \"integer maxdepth\" 64\n");
    rib.line("Display \"%s.exr\" \"openexr\" \"rgb\"\nFormat %d %d 1\n", scene.name.c_str(),
             scene.size, scene.size);
    rib.line("PixelFilter \"box\" 1 1\nProjection \"perspective\" \"fov\" %.12g\nScale -1 1 1\n",
             degrees);
    rib.text("Translate ");
    rib.point(-scene.eye);
    rib.text("\nWorldBegin\n");
}

void beginLamp(RibFile &rib, int handle, float radiance) {
    rib.line("AttributeBegin\nAreaLightSource \"arealight\" %d \"radiance\" %.9g \"onesided\" 0\n"
             "Surface \"matte\" \"Ka\" 0 \"Kd\" 0\n",
             handle, double(radiance));
}

/// Returns how many lights there are; their handles are 1, 2, ...
int writeLamps(RibFile &rib, const SceneDescription &scene) {
    int lights = 0;
    for (const QuadLamp &lamp : scene.quads) {
        beginLamp(rib, ++lights, lamp.radiance);
        rib.text("Polygon \"P\" [");
        rib.point(lamp.corner), rib.point(lamp.corner + lamp.edgeU);
        rib.point(lamp.corner + lamp.edgeU + lamp.edgeV), rib.point(lamp.corner + lamp.edgeV);
        rib.text("]\nAttributeEnd\n");
    }
    auto sphere = [&](Vec3 centre, float radius, float radiance) {
        beginLamp(rib, ++lights, radiance);
        rib.text("Translate ");
        rib.point(centre);
        rib.line("\nSphere %.9g %.9g %.9g 360\nAttributeEnd\n", double(radius), double(-radius),
                 double(radius));
    };
    for (const SphereLamp &lamp : scene.spheres)
        sphere(lamp.centre, lamp.radius, lamp.radiance);
    if (scene.domeRadiance > 0) // The same radiance from all sides, however far it is.
        sphere({0, 0, 0}, scene.domeRadius, scene.domeRadiance);
    return lights;
}

void writeMesh(RibFile &rib, const DiffuseMesh &mesh) {
    rib.line("Color [%.9g %.9g %.9g]\nPointsPolygons [", double(mesh.albedo), double(mesh.albedo),
             double(mesh.albedo));
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        rib.text(i % 40 == 39 ? "3\n" : "3 ");
    rib.text("]\n[");
    for (auto [a, b, c] : mesh.triangles)
        rib.line("%u %u %u\n", a, b, c);
    rib.text("]\n\"P\" [");
    for (Vec3 vertex : mesh.vertices)
        rib.point(vertex), rib.text("\n");
    rib.text("]\n");
}

} // namespace

void writeRib(const SceneDescription &scene, const std::string &file) {
    RibFile rib(file);
    writeCamera(rib, scene);
    int lights = writeLamps(rib, scene);
    // A light declared within a block is off outside it, unless switched on.
    for (int light = 1; light <= lights; ++light)
        rib.line("Illuminate %d 1\n", light);
    rib.text("Surface \"matte\"\n");
    for (const DiffuseMesh &mesh : scene.meshes)
        writeMesh(rib, mesh);
    rib.text("WorldEnd\n");
    rib.finish();
}

} // namespace candela::bench
