// SPDX-License-Identifier: Apache-2.0
#include "world/scene/shape_builder.h"

#include "world/scene/appearance_builder.h"
#include "world/shapes/dicing_plan.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace candela {

namespace {

/// The shapes of an object at one level of detail.
struct ObjectShapes {
    std::uint32_t first = 0, count = 0;
};

class ShapeBuilder {
public:
    ShapeBuilder(const DeclaredWorld &declared, SceneState &state, ShaderLibrary &library,
                 DiagnosticSink &sink)
        : declared_(declared), state_(state), points_(state.points), sink_(sink),
          looks_(state, library), plan_(state.camera) {}

    RayGeometry build() {
        placements_ = placementsOf(declared_);
        countPlacements();
        for (const DeclaredPrimitive &primitive : declared_.world.primitives)
            addToWorld(primitive, primitive.outerFromPrimitive, primitive.attributes,
                       primitive.attributes->flipNormal);
        for (const Placement &placement : placements_)
            if (timesPlaced_[placement.object] == 1)
                addSinglePlacement(placement);
        points_.worldShapes = std::uint32_t(points_.shapes.size());
        chooseLevels();
        addInstances();
        markShining();
        std::vector<RayShape> meshes = plan_.dice(points_.shapes);
        looks_.finish();
        return finish(std::move(meshes));
    }

private:
    void countPlacements() {
        timesPlaced_.assign(declared_.objects.size(), 0);
        for (const Placement &placement : placements_)
            ++timesPlaced_[placement.object];
    }

    /// Adds the shapes of one primitive; `then` is told of each, and may take it back.
    template <class Then>
    void addShapes(const DeclaredPrimitive &primitive, const Matrix4 &outerFromPrimitive,
                   const Attributes &shaping, Then then) {
        for (auto &surface : makeSurfaces(primitive.record, shaping, sink_)) {
            std::optional<Shape> shape = makeShape(surface, outerFromPrimitive);
            if (!shape) {
                sink_.warning(primitive.record->where, "the transformation of this primitive is "
                                                       "singular; it is left out");
                return;
            }
            points_.shapes.push_back(std::move(*shape));
            if (!then(std::uint32_t(points_.shapes.size() - 1)))
                points_.shapes.pop_back();
        }
    }

    void addToWorld(const DeclaredPrimitive &primitive, const Matrix4 &currentFromPrimitive,
                    const std::shared_ptr<const Attributes> &attributes, bool turned) {
        addShapes(primitive, currentFromPrimitive, *primitive.attributes, [&](std::uint32_t shape) {
            if (!looks_.add(shape, attributes, turned))
                return false;
            plan_.add(points_.shapes[shape], attributes->shadingRate);
            points_.appearances.back().id = std::int32_t(shape) + 1;
            const Shape &added = points_.shapes[shape];
            for (const Matrix4 *matrix : {&added.outerFromShape, &added.shapeFromOuter})
                points_.shapeMatrices.insert(points_.shapeMatrices.end(), matrix->m.begin(),
                                             matrix->m.end());
            return true;
        });
    }

    /// What stands but once needs no instance.
    void addSinglePlacement(const Placement &placement) {
        for (const DeclaredPrimitive &primitive : declared_.objects[placement.object].primitives)
            addToWorld(primitive, primitive.outerFromPrimitive * placement.currentFromObject,
                       placement.attributes, primitive.attributes->flipNormal != placement.turned);
    }

    /// How finely each placement wants its object, and by that its level.
    void chooseLevels() {
        std::vector<Box3> bounds(declared_.objects.size());
        for (std::size_t i = 0; i < bounds.size(); ++i)
            if (timesPlaced_[i] > 1)
                bounds[i] = boundOf(declared_.objects[i]);
        std::vector<float> finest(bounds.size(), INFINITY);
        pixels_.clear();
        for (const Placement &placement : placements_) {
            float pixel = 0;
            if (timesPlaced_[placement.object] > 1) {
                pixel = plan_.nearestPixel(bounds[placement.object], placement.currentFromObject);
                finest[placement.object] = std::min(finest[placement.object], pixel);
            }
            pixels_.push_back(pixel);
        }
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            const float ratio = pixels_[i] / finest[placements_[i].object];
            levels_.push_back(ratio < 8 ? 0 : ratio < 64 ? 1 : 2);
            pixels_[i] = finest[placements_[i].object] * (levels_[i] == 0   ? 1.0f
                                                          : levels_[i] == 1 ? 8.0f
                                                                            : 64.0f);
        }
    }

    Box3 boundOf(const DeclaredGroup &object) {
        Box3 bound;
        for (const DeclaredPrimitive &primitive : object.primitives)
            for (auto &surface : makeSurfaces(primitive.record, *primitive.attributes, silent_))
                bound.add(transformBox(primitive.outerFromPrimitive, surface->bound()));
        return bound;
    }

    /// The shapes of a placed object, made when they are first wanted.
    const ObjectShapes &shapesOf(std::size_t placement) {
        const int object = placements_[placement].object;
        const bool exact = std::ranges::all_of(
            declared_.objects[object].primitives, [](const DeclaredPrimitive &primitive) {
                return std::holds_alternative<PolygonsRecord>(primitive.record->shape);
            });
        auto [place, isNew] = objectShapes_.try_emplace({object, exact ? 0 : levels_[placement]});
        ObjectShapes &shapes = place->second;
        if (!isNew)
            return shapes;
        shapes.first = std::uint32_t(points_.shapes.size());
        turnedShapes_.resize(shapes.first, false);
        const float rate = placements_[placement].attributes->shadingRate;
        for (const DeclaredPrimitive &primitive : declared_.objects[object].primitives)
            addShapes(primitive, primitive.outerFromPrimitive, *primitive.attributes,
                      [&](std::uint32_t shape) {
                          plan_.add(points_.shapes[shape], rate, pixels_[placement]);
                          turnedShapes_.push_back(primitive.attributes->flipNormal);
                          return true;
                      });
        shapes.count = std::uint32_t(points_.shapes.size()) - shapes.first;
        return shapes;
    }

    void addInstances() {
        // Appearances are shared by what looks alike; shapes that shine are lights of their own.
        std::map<std::tuple<std::uint32_t, const Attributes *, bool>, std::int32_t> known;
        std::int32_t nextId = std::int32_t(points_.worldShapes);
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            const Placement &placement = placements_[i];
            if (timesPlaced_[placement.object] <= 1)
                continue;
            const ObjectShapes &shapes = shapesOf(i);
            auto [place, isNew] =
                known.try_emplace({shapes.first, placement.attributes.get(), placement.turned}, 0);
            if (isNew || place->second < 0)
                place->second = addAppearances(shapes, placement);
            if (place->second == noAppearance)
                continue;
            Instance instance;
            instance.firstShape = shapes.first;
            instance.firstAppearance = place->second;
            instance.firstId = nextId;
            instance.stretch = largestStretch(placement.currentFromObject);
            instance.handedness = flipsHandedness(placement.currentFromObject) ? -1 : 1;
            nextId += std::int32_t(shapes.count);
            points_.instances.push_back(instance);
            shapeCounts_.push_back(shapes.count);
            const Matrix4 inverted = inverse(placement.currentFromObject).value_or(Matrix4{});
            for (const Matrix4 *matrix : {&placement.currentFromObject, &inverted})
                points_.instanceMatrices.insert(points_.instanceMatrices.end(), matrix->m.begin(),
                                                matrix->m.end());
            if (shinesFrom(instance.firstAppearance, shapes.count)) {
                known.erase({shapes.first, placement.attributes.get(), placement.turned});
                // Lights of this form can't be sampled but by triangles.
                if (!keepsSpheres(placement.currentFromObject))
                    for (std::uint32_t k = 0; k < shapes.count; ++k)
                        points_.shapes[shapes.first + k].mayBeSphere = false;
            }
        }
    }

    static constexpr std::int32_t noAppearance = -1;

    std::int32_t addAppearances(const ObjectShapes &shapes, const Placement &placement) {
        const std::int32_t first = std::int32_t(points_.appearances.size());
        for (std::uint32_t k = 0; k < shapes.count; ++k) {
            const std::uint32_t shape = shapes.first + k;
            if (!looks_.add(shape, placement.attributes, placement.turned != turnedShapes_[shape]))
                return noAppearance;
            points_.appearances.back().id = std::int32_t(k) + 1;
        }
        return first;
    }

    bool shinesFrom(std::int32_t first, std::uint32_t count) const {
        for (std::uint32_t k = 0; k < count; ++k)
            if (looks_.shines(first + std::int32_t(k)))
                return true;
        return false;
    }

    void markShining() {
        for (std::size_t i = 0; i < points_.appearances.size(); ++i)
            if (looks_.shines(std::int32_t(i))) {
                const std::uint32_t number = looks_.shapes()[i];
                plan_.makeFine(number, points_.shapes[number]);
            }
    }

    void dress(RayShape &shape, std::int32_t index) const {
        const Appearance &appearance = points_.appearances[index];
        shape.opaque = looks_.isOpaque(index);
        if (points_.details[index].attributes->sides == 1)
            shape.frontSign = appearance.elementSign < 0 ? -1 : 1;
    }

    RayGeometry finish(std::vector<RayShape> meshes) {
        measure(meshes);
        RayGeometry geometry;
        for (std::uint32_t i = 0; i < points_.worldShapes; ++i) {
            dress(meshes[i], std::int32_t(i));
            geometry.world.push_back(std::move(meshes[i]));
        }
        // Objects that rays meet differently (opacity, one-sidedness) are objects of their own.
        std::map<std::vector<std::int32_t>, std::uint32_t> variants;
        for (std::size_t i = 0; i < points_.instances.size(); ++i) {
            const Instance &instance = points_.instances[i];
            RayObject object;
            std::vector<std::int32_t> key{std::int32_t(instance.firstShape)};
            for (std::uint32_t k = 0; k < shapeCounts_[i]; ++k) {
                RayShape looks;
                dress(looks, instance.firstAppearance + std::int32_t(k));
                key.push_back(looks.opaque * 4 + looks.frontSign);
                object.push_back(std::move(looks));
            }
            auto [place, isNew] =
                variants.try_emplace(std::move(key), std::uint32_t(geometry.objects.size()));
            if (isNew) {
                for (std::uint32_t k = 0; k < shapeCounts_[i]; ++k) {
                    RayShape mesh = meshes[instance.firstShape + k];
                    mesh.opaque = object[k].opaque, mesh.frontSign = object[k].frontSign;
                    object[k] = std::move(mesh);
                }
                geometry.objects.push_back(std::move(object));
            }
            RayInstance placed{place->second, instance.firstShape, {}};
            std::copy_n(points_.matricesOf(std::uint32_t(i)), 16,
                        placed.currentFromObject.m.begin());
            geometry.instances.push_back(placed);
        }
        return geometry;
    }

    /// The scene's extent and its statistics.
    void measure(const std::vector<RayShape> &meshes) {
        Box3 box;
        std::vector<Box3> own(meshes.size());
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const RayShape &mesh = meshes[i];
            for (Vec3 position : mesh.positions)
                own[i].add(position);
            if (const Vec3 r{mesh.radius, mesh.radius, mesh.radius}; mesh.radius > 0)
                own[i].add(mesh.centre - r), own[i].add(mesh.centre + r);
            state_.statistics.triangles += mesh.triangles.size();
            if (i < points_.worldShapes && !own[i].empty())
                box.add(own[i]);
        }
        for (std::size_t i = 0; i < points_.instances.size(); ++i) {
            Matrix4 currentFromObject;
            std::copy_n(points_.matricesOf(std::uint32_t(i)), 16, currentFromObject.m.begin());
            for (std::uint32_t k = 0; k < shapeCounts_[i]; ++k)
                if (const Box3 &part = own[points_.instances[i].firstShape + k]; !part.empty())
                    box.add(transformBox(currentFromObject, part));
        }
        state_.statistics.primitives = meshes.size();
        state_.statistics.instances = points_.instances.size();
        if (!box.empty()) {
            state_.centre = box.centre();
            state_.radius = std::max(length(box.extent()) / 2, 1e-6f);
        }
    }

    const DeclaredWorld &declared_;
    SceneState &state_;
    PointTables &points_;
    DiagnosticSink &sink_;
    DiagnosticList silent_; ///< For what is reported when shapes are made in earnest.
    AppearanceBuilder looks_;
    DicingPlan plan_;
    std::vector<Placement> placements_;
    std::vector<int> timesPlaced_;           ///< By object.
    std::vector<int> levels_;                ///< By placement.
    std::vector<float> pixels_;              ///< By placement: object units a pixel.
    std::vector<std::uint32_t> shapeCounts_; ///< By instance.
    std::vector<bool> turnedShapes_;         ///< By shape: its definition reverses the orientation.
    std::map<std::pair<int, int>, ObjectShapes> objectShapes_; ///< By object and level.
};

} // namespace

RayGeometry buildShapes(const DeclaredWorld &declared, SceneState &state, ShaderLibrary &library,
                        DiagnosticSink &sink) {
    return ShapeBuilder(declared, state, library, sink).build();
}

} // namespace candela
