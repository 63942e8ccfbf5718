// SPDX-License-Identifier: Apache-2.0
#include "scenes/description.h"

#include "cornell_box.h"

#include <map>
#include <stdexcept>

namespace candela::bench {
namespace {

/// The box's diffuse quadrilaterals, a mesh an albedo.
SceneDescription boxWithoutLamp(const char *name) {
    SceneDescription scene;
    scene.name = name;
    scene.eye = CornellBox::eye;
    scene.halfExtent = CornellBox::halfExtent;
    CornellBox box;
    std::map<float, DiffuseMesh> meshes;
    for (std::size_t quad = 1; quad < box.vertices.size() / 4; ++quad) {
        const Vec3 *v = &box.vertices[4 * quad];
        meshes[box.albedos[2 * quad]].addQuad(v[0], v[1], v[2], v[3]);
    }
    for (auto &[albedo, mesh] : meshes) {
        mesh.albedo = albedo;
        scene.meshes.push_back(std::move(mesh));
    }
    return scene;
}

SceneDescription cornellGrey() {
    SceneDescription scene = boxWithoutLamp("cornell_grey");
    using B = CornellBox;
    scene.quads.push_back({{B::lampX0, B::lampY, B::lampZ0},
                           {B::lampX1 - B::lampX0, 0, 0},
                           {0, 0, B::lampZ1 - B::lampZ0},
                           B::lampRadiance});
    return scene;
}

/// Four balls of unequal brightness under a closed ceiling.
SceneDescription cornellSpheres() {
    SceneDescription scene = boxWithoutLamp("cornell_spheres");
    using B = CornellBox;
    DiffuseMesh lid;
    lid.albedo = .73f;
    lid.addQuad({B::lampX0, B::lampY, B::lampZ0}, {B::lampX1, B::lampY, B::lampZ0},
                {B::lampX1, B::lampY, B::lampZ1}, {B::lampX0, B::lampY, B::lampZ1});
    scene.meshes.push_back(std::move(lid));
    scene.spheres = {{{1.5f, 4.8f, 1.5f}, .2f, 10},
                     {{4.0f, 4.8f, 1.5f}, .2f, 20},
                     {{1.5f, 4.8f, 4.0f}, .2f, 30},
                     {{4.0f, 4.8f, 4.0f}, .2f, 15}};
    return scene;
}

/// A ball of 1000 x 500 cells, its points moved along the normal by waves.
DiffuseMesh displacedBall() {
    constexpr int columns = 1000, rows = 501;
    constexpr double pi = std::numbers::pi;
    DiffuseMesh ball;
    ball.albedo = .7f;
    auto at = [](int row, int column) { return std::uint32_t(row * columns + column % columns); };
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < columns; ++column) {
            double polar = pi * row / rows, turn = 2 * pi * column / columns;
            double x = std::sin(polar) * std::cos(turn), y = std::cos(polar),
                   z = std::sin(polar) * std::sin(turn);
            double radius = 1 + .04 * std::sin(17 * x) * std::sin(19 * y) * std::sin(23 * z) +
                            .01 * std::sin(83 * x + 2) * std::sin(89 * y) * std::sin(97 * z + 1);
            ball.vertices.push_back({float(radius * x), float(radius * y), float(radius * z)});
        }
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            // One triangle a cell at the poles.
            if (row > 0)
                ball.triangles.push_back(
                    {at(row, column), at(row, column + 1), at(row + 1, column)});
            if (row + 1 < rows)
                ball.triangles.push_back(
                    {at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)});
        }
    return ball;
}

SceneDescription dome() {
    SceneDescription scene;
    scene.name = "dome";
    scene.eye = {0, 0, -4};
    scene.halfExtent = .3f;
    scene.meshes.push_back(displacedBall());
    scene.spheres = {{{2, 2.5f, -2}, .03f, 3000}};
    scene.domeRadiance = .5f;
    scene.domeRadius = 100;
    return scene;
}

/// 20 x 40 x 6 metres with 14 pillars, and 1,000 lamps whose powers span two decades.
SceneDescription hall() {
    SceneDescription scene;
    scene.name = "hall";
    scene.eye = {0, 1.7f, .5f};
    scene.halfExtent = .6f;
    DiffuseMesh room;
    room.albedo = .6f;
    room.addBox({-10, 0, 0}, {10, 6, 40});
    for (float z = 5; z < 40; z += 5)
        for (float x : {-5.0f, 5.0f})
            room.addBox({x - .4f, 0, z - .4f}, {x + .4f, 6, z + .4f});
    scene.meshes.push_back(std::move(room));
    RandomNumbers random(1000);
    for (int row = 0; row < 50; ++row)
        for (int column = 0; column < 20; ++column) {
            float height = 4.8f + .8f * random.uniform();
            // Between the pillars' planes: columns stand at odd halves of a metre.
            Vec3 corner{float(column) - 9.55f, height, .8f * float(row) + .3f};
            float radiance = 6 * std::pow(100.0f, random.uniform());
            scene.quads.push_back({corner, {.1f, 0, 0}, {0, 0, .1f}, radiance});
        }
    return scene;
}

} // namespace

SceneDescription describeScene(const std::string &name) {
    static const std::map<std::string, SceneDescription (*)()> scenes = {
        {"cornell_grey", cornellGrey},
        {"cornell_spheres", cornellSpheres},
        {"dome", dome},
        {"hall", hall}};
    auto found = scenes.find(name);
    if (found == scenes.end())
        throw std::invalid_argument("no scene is called " + name);
    return found->second();
}

} // namespace candela::bench
