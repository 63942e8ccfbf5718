// SPDX-License-Identifier: Apache-2.0
#include "world/scene/shape_builder.h"

#include "world/displacement/displacement_builder.h"
#include "world/scene/appearance_builder.h"
#include "world/scene/moving_parts.h"
#include "world/scene/placement_details.h"
#include "world/scene/ray_geometry.h"
#include "world/shapes/dicing_plan.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>

namespace candela {

namespace {

/// The shapes of an object at one level of detail.
struct ObjectShapes {
    std::uint32_t first = 0, count = 0;
};

class ShapeBuilder {
public:
    ShapeBuilder(DeclaredWorld &declared, SceneState &state, ShaderLibrary &library,
                 DiagnosticSink &sink)
        : declared_(declared), state_(state), points_(state.points), sink_(sink),
          looks_(state, library), plan_(state.camera),
          displacements_(library, state.options,
                         state.classic ? ir::LightRule::Classic : ir::LightRule::Path,
                         declared.systems, state.camera),
          all_(placementsOf(declared)), placements_(all_.all),
          timesPlaced_(declared.objects.size()) {}

    RayGeometry build() {
        declared_.letGoOfInstances();
        for (const Placement &placement : placements_)
            ++timesPlaced_[placement.object];
        for (const DeclaredPrimitive &primitive : declared_.world.primitives)
            if (!primitive.motion)
                addAsDeclared(primitive);
        const std::vector<MovingGroup> groups = movingGroupsOf(declared_);
        for (const MovingGroup &group : groups)
            if (group.steps.size() == 1)
                addGroup(group);
        for (const Placement &placement : placements_)
            if (timesPlaced_[placement.object] == 1 && placement.steps.empty())
                addSinglePlacement(placement);
        for (std::uint32_t shape = 0; shape < points_.shapes.size(); ++shape)
            addShapeMatrices(points_.shapes[shape]);
        points_.worldShapes = std::uint32_t(points_.shapes.size());
        addMovingThings(groups);
        details_ = detailsOf(placements_, timesPlaced_, declared_, plan_);
        addInstances();
        markShining();
        points_.shapesChange = std::ranges::any_of(
            points_.shapes, [](const Shape &shape) { return shape.surface->steps() > 1; });
        surfaces_.clear();
        declared_.letGoOfRecords();
        std::vector<RayShape> meshes = plan_.dice(points_.shapes);
        displacements_.report(sink_);
        looks_.finish();
        measure(meshes, shapeCounts_, state_);
        RayGeometry geometry = arrange(std::move(meshes), shapeCounts_, points_, looks_);
        geometry.solids = bodies_.solids(points_.worldShapes);
        return geometry;
    }

private:
    using Surfaces = std::vector<std::shared_ptr<const Surface>>;

    /// Who looks how at what is to be displaced.
    struct Displacing {
        std::shared_ptr<const Attributes> attributes;
        Matrix4 currentFromOuter;
        bool turned = false;
        float pixel = 0;
    };

    DisplacedStages displacedBy(const std::shared_ptr<const Surface> &surface,
                                const Matrix4 &outerFromShape, const Displacing &how) {
        return displacements_.displace(
            {surface, outerFromShape * how.currentFromOuter, how.attributes, how.turned, how.pixel},
            looks_.movingShader(*how.attributes, overridingNames(*surface)));
    }

    /// Adds the shapes of one primitive; `then` is told of each, and may take it back.
    template <class Then>
    void addShapes(const DeclaredPrimitive &primitive, const Matrix4 &outerFromPrimitive,
                   const Surfaces &surfaces, const Displacing &displacing, Then then) {
        for (const auto &surface : surfaces) {
            std::optional<Shape> shape = makeShape(surface, outerFromPrimitive);
            if (!shape) {
                sink_.warning(primitive.record->where, "the transformation of this primitive is "
                                                       "singular; it is left out");
                return;
            }
            DisplacedStages displaced = displacedBy(surface, outerFromPrimitive, displacing);
            if (surface->steps() > 1 && (displaced.mover || displaced.surface != surface)) {
                sink_.warning(primitive.record->where,
                              "a primitive that is displaced keeps the shape that it has when the "
                              "shutter opens");
                displaced = displacedBy(surface->step(0), outerFromPrimitive, displacing);
            }
            shape->surface = displaced.surface, shape->displacement = displaced.mover;
            points_.shapes.push_back(std::move(*shape));
            displaced_.push_back(std::move(displaced));
            if (!then(std::uint32_t(points_.shapes.size() - 1)))
                points_.shapes.pop_back(), displaced_.pop_back();
        }
    }

    void addToWorld(const DeclaredPrimitive &primitive, const Matrix4 &currentFromPrimitive,
                    const std::shared_ptr<const Attributes> &attributes, bool turned,
                    const Presence &presence, std::int32_t node) {
        if (presence.isNone())
            return;
        const Displacing displacing{attributes, {}, turned, 0};
        const Surfaces surfaces =
            makeSurfaces(primitive.record, *primitive.attributes, declared_.shutter, sink_);
        addShapes(primitive, currentFromPrimitive, surfaces, displacing, [&](std::uint32_t shape) {
            if (!looks_.add(shape, attributes, turned, presence))
                return false;
            plan_.add(points_.shapes[shape], attributes->shadingRate, steps_);
            points_.appearances.back().id = std::int32_t(shape) + 1;
            bodies_.addShape(shape, node, primitive.record->where);
            return true;
        });
    }

    void addShapeMatrices(const Shape &shape) {
        for (const Matrix4 *matrix : {&shape.outerFromShape, &shape.shapeFromOuter})
            points_.shapeMatrices.insert(points_.shapeMatrices.end(), matrix->m.begin(),
                                         matrix->m.end());
    }

    void addAsDeclared(const DeclaredPrimitive &primitive) {
        const auto number = std::size_t(&primitive - declared_.world.primitives.data());
        addToWorld(primitive, primitive.outerFromPrimitive, primitive.attributes,
                   primitive.turned(),
                   candela::presenceOf(*primitive.attributes, Matrix4{}, state_.options),
                   all_.nodes.empty() ? -1 : all_.nodes[number]);
    }

    void addGroup(const MovingGroup &group) {
        for (const DeclaredPrimitive *primitive : group.primitives)
            addAsDeclared(*primitive);
    }

    /// What moves in the world stands as it is when the shutter opens, in a space that moves: it is
    /// an instance like others.
    void addMovingThings(const std::vector<MovingGroup> &groups) {
        for (const MovingGroup &group : groups)
            if (group.steps.size() > 1)
                addMoving(group.steps, [&] { addGroup(group); });
        for (const Placement &placement : placements_)
            if (timesPlaced_[placement.object] == 1 && !placement.steps.empty())
                addMoving(stepsFromOpen(placement.steps), [&] { addSinglePlacement(placement); });
    }

    template <class Add> void addMoving(const std::vector<Matrix4> &steps, Add addShapesOfIt) {
        const auto first = std::uint32_t(points_.shapes.size());
        const auto firstAppearance = std::int32_t(points_.appearances.size());
        steps_ = steps;
        addShapesOfIt();
        steps_ = {};
        const auto count = std::uint32_t(points_.shapes.size()) - first;
        if (count > 0) {
            bodies_.addInstanceOfWorld(first, count);
            addInstance({}, steps, {first, count}, firstAppearance, 0);
        }
    }

    /// What stands but once needs no instance.
    void addSinglePlacement(const Placement &placement) {
        const auto &primitives = declared_.objects[placement.object].primitives;
        for (std::size_t k = 0; k < primitives.size(); ++k)
            addToWorld(primitives[k],
                       primitives[k].outerFromPrimitive * placement.currentFromObject,
                       placement.attributes, primitives[k].turned() != placement.turned,
                       presenceOf(placement), nodeOf(placement, k));
    }

    Presence presenceOf(const Placement &placement) const {
        return candela::presenceOf(*placement.attributes, placement.currentFromObject,
                                   state_.options);
    }

    /// The body that primitive k of the placed object bounds, or helps to; -1: none of a solid.
    std::int32_t nodeOf(const Placement &placement, std::size_t k) const {
        return placement.firstNode < 0 ? -1 : all_.nodes[std::size_t(placement.firstNode) + k];
    }

    /// Of a placement's primitive, which its definition may turn round.
    Displacing displacingOf(std::size_t number, bool turned) const {
        const Placement &placement = placements_[number];
        const Matrix4 &currentFromObject = placement.currentFromObject;
        return {placement.attributes, currentFromObject, turned != placement.turned,
                details_[number].pixel * largestStretch(currentFromObject)};
    }

    /// What stands in two places is one shape unless displacement makes two things of it.
    struct Variant {
        std::size_t placement;
        ObjectShapes shapes;
    };

    /// Of objects, made once.
    const Surfaces &surfacesOf(const DeclaredPrimitive &of) {
        auto [place, isNew] = surfaces_.try_emplace(&of);
        if (isNew)
            place->second = makeSurfaces(of.record, *of.attributes, declared_.shutter, sink_);
        return place->second;
    }

    /// What a placement shows is displaced, by a displacement shader or by its surface shader.
    bool isDisplaced(const Placement &placement) {
        const Attributes &attributes = *placement.attributes;
        auto [known, isNew] =
            movedBySurface_.try_emplace({placement.object, attributes.surface.get()}, false);
        if (isNew && attributes.surface)
            for (const DeclaredPrimitive &primitive :
                 declared_.objects[placement.object].primitives)
                for (const auto &surface : surfacesOf(primitive))
                    known->second |=
                        looks_.movingShader(attributes, overridingNames(*surface)).has_value();
        return attributes.deformation || attributes.displacement || known->second;
    }

    bool fits(const Variant &variant, std::size_t number) {
        const Placement &placement = placements_[number];
        if (!isDisplaced(placement) ||
            placements_[variant.placement].currentFromObject.m == placement.currentFromObject.m)
            return true;
        const auto [first, count] = variant.shapes;
        for (std::uint32_t shape = first; shape < first + count; ++shape) {
            const DisplacedStages &there = displaced_[shape];
            if (!displaceAlike(there, displacedBy(there.own, points_.shapes[shape].outerFromShape,
                                                  displacingOf(number, turnedShapes_[shape]))))
                return false;
        }
        return true;
    }

    /// The shapes of a placed object, made when they are first wanted.
    const ObjectShapes &shapesOf(std::size_t placement) {
        const int object = placements_[placement].object;
        const Attributes &attributes = *placements_[placement].attributes;
        const bool displaced = isDisplaced(placements_[placement]);
        const bool exact =
            !displaced &&
            std::ranges::all_of(
                declared_.objects[object].primitives, [](const DeclaredPrimitive &primitive) {
                    return std::holds_alternative<PolygonsRecord>(primitive.record->shape);
                });
        std::deque<Variant> &variants =
            objectShapes_[{object, exact ? 0 : details_[placement].level,
                           displaced ? attributes.displacement.get() : nullptr,
                           displaced ? attributes.surface.get() : nullptr,
                           displaced ? attributes.deformation.get() : nullptr,
                           displaced && placements_[placement].turned}];
        // Where no two are alike nobody looks through all of them.
        constexpr std::size_t looks = 8;
        for (std::size_t k = 0; k < std::min(looks, variants.size()); ++k)
            if (const Variant &known = variants[variants.size() - 1 - k]; fits(known, placement))
                return known.shapes;
        ObjectShapes &shapes = variants.emplace_back(Variant{placement, {}}).shapes;
        shapes.first = std::uint32_t(points_.shapes.size());
        turnedShapes_.resize(shapes.first, false);
        const float rate = placements_[placement].attributes->shadingRate;
        const std::uint32_t number = ++objects_;
        for (const DeclaredPrimitive &primitive : declared_.objects[object].primitives)
            addShapes(primitive, primitive.outerFromPrimitive, surfacesOf(primitive),
                      displacingOf(placement, primitive.turned()), [&](std::uint32_t shape) {
                          plan_.add(points_.shapes[shape], rate, details_[placement].pixel, number);
                          turnedShapes_.push_back(primitive.turned());
                          primitiveOfShape_.resize(shape);
                          primitiveOfShape_.push_back(&primitive);
                          return true;
                      });
        shapes.count = std::uint32_t(points_.shapes.size()) - shapes.first;
        return shapes;
    }

    void addInstances() {
        // Appearances are shared by what looks alike; shapes that shine are lights of their own.
        std::map<std::tuple<std::uint32_t, const Attributes *, bool, float, float>, std::int32_t>
            known;
        std::int32_t nextId = std::int32_t(points_.shapes.size());
        makeRoomForInstances();
        for (std::size_t i = 0; i < placements_.size(); ++i) {
            Placement &placement = placements_[i];
            const Presence presence = presenceOf(placement);
            if (timesPlaced_[placement.object] <= 1 || presence.isNone())
                continue;
            const ObjectShapes &shapes = shapesOf(i);
            const std::tuple looks(shapes.first, placement.attributes.get(), placement.turned,
                                   presence.from, presence.until);
            auto [place, isNew] = known.try_emplace(looks, 0);
            if (isNew || place->second < 0)
                place->second = addAppearances(shapes, placement, presence);
            if (place->second == noAppearance)
                continue;
            const std::int32_t firstAppearance = place->second;
            addBodies(shapes, placement);
            addInstance(placement.currentFromObject, placement.steps, shapes, firstAppearance,
                        nextId);
            placement.steps = {};
            nextId += std::int32_t(shapes.count);
            if (shinesFrom(firstAppearance, shapes.count))
                known.erase(looks);
        }
    }

    /// There may be millions.
    void makeRoomForInstances() {
        std::size_t steps = points_.steps.size();
        for (const Placement &placement : placements_)
            steps += placement.steps.size();
        const std::size_t count = points_.instances.size() + placements_.size();
        points_.steps.reserve(steps), points_.instances.reserve(count);
        points_.instanceMatrices.reserve(32 * count), shapeCounts_.reserve(count);
    }

    void addBodies(const ObjectShapes &shapes, const Placement &placement) {
        std::vector<std::int32_t> nodes;
        const auto *first = declared_.objects[placement.object].primitives.data();
        for (std::uint32_t k = 0; placement.firstNode >= 0 && k < shapes.count; ++k) {
            const DeclaredPrimitive *primitive = primitiveOfShape_[shapes.first + k];
            nodes.push_back(nodeOf(placement, std::size_t(primitive - first)));
            bodies_.addShape(shapes.first + k, nodes.back(), primitive->record->where);
        }
        bodies_.addInstance(std::move(nodes));
    }

    /// `steps`: empty where it stands still.
    void addInstance(const Matrix4 &currentFromObject, std::span<const Matrix4> steps,
                     const ObjectShapes &shapes, std::int32_t firstAppearance,
                     std::int32_t firstId) {
        Instance instance;
        instance.firstShape = shapes.first, instance.shapes = shapes.count;
        instance.firstAppearance = firstAppearance;
        instance.firstId = firstId;
        instance.stretch = largestStretch(currentFromObject);
        for (const Matrix4 &step : steps)
            instance.stretch = std::max(instance.stretch, largestStretch(step));
        instance.handedness = flipsHandedness(currentFromObject) ? -1 : 1;
        instance.firstStep = std::uint32_t(points_.steps.size());
        instance.steps = std::uint32_t(steps.size());
        points_.steps.insert(points_.steps.end(), steps.begin(), steps.end());
        points_.instances.push_back(instance);
        shapeCounts_.push_back(shapes.count);
        const Matrix4 inverted = inverse(currentFromObject).value_or(Matrix4{});
        for (const Matrix4 *matrix : {&currentFromObject, &inverted})
            points_.instanceMatrices.insert(points_.instanceMatrices.end(), matrix->m.begin(),
                                            matrix->m.end());
        // Lights of this form can't be sampled but by triangles.
        if (shinesFrom(firstAppearance, shapes.count) &&
            (!keepsSpheres(currentFromObject) || turns(steps)))
            for (std::uint32_t k = 0; k < shapes.count; ++k)
                points_.shapes[shapes.first + k].mayBeRound = false;
    }

    static bool turns(std::span<const Matrix4> steps) {
        return std::ranges::any_of(steps, [&](const Matrix4 &step) {
            return !std::equal(step.m.begin(), step.m.begin() + 12, steps.front().m.begin());
        });
    }

    static constexpr std::int32_t noAppearance = -1;

    std::int32_t addAppearances(const ObjectShapes &shapes, const Placement &placement,
                                const Presence &presence) {
        const std::int32_t first = std::int32_t(points_.appearances.size());
        for (std::uint32_t k = 0; k < shapes.count; ++k) {
            const std::uint32_t shape = shapes.first + k;
            if (!looks_.add(shape, placement.attributes, placement.turned != turnedShapes_[shape],
                            presence))
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
                Shape &shape = points_.shapes[number];
                if (shape.surface->steps() > 1) {
                    shape.surface = shape.surface->step(0);
                    sink_.warning({}, "what shines keeps the shape that it has when the shutter "
                                      "opens");
                }
                // Lights of these forms can't be sampled but by triangles.
                shape.mayBeRound &=
                    shape.surface->roundElements().isOneBall() && !bodies_.isCut(number);
                plan_.makeFine(number, points_.shapes[number]);
            }
    }

    DeclaredWorld &declared_;
    SceneState &state_;
    PointTables &points_;
    DiagnosticSink &sink_;
    AppearanceBuilder looks_;
    DicingPlan plan_;
    DisplacementBuilder displacements_;
    Placements all_;
    std::vector<Placement> &placements_;
    SolidBodies bodies_{declared_.solids, all_.solids};
    std::vector<int> timesPlaced_;           ///< By object.
    std::vector<PlacementDetail> details_;   ///< By placement.
    std::vector<std::uint32_t> shapeCounts_; ///< By instance.
    std::span<const Matrix4> steps_;         ///< Of what is added to the world now, if it moves.
    std::vector<bool> turnedShapes_;         ///< By shape: its definition reverses the orientation.
    std::vector<const DeclaredPrimitive *> primitiveOfShape_;             ///< Of shapes of objects.
    std::vector<DisplacedStages> displaced_;                              ///< By shape.
    std::map<const DeclaredPrimitive *, Surfaces> surfaces_;              ///< Of objects.
    std::map<std::pair<int, const ShaderRecord *>, bool> movedBySurface_; ///< By object.
    /// By object and level; where it is displaced by displacement and surface shader and by
    /// deformation, and whether they see normals turned round.
    std::map<std::tuple<int, int, const ShaderRecord *, const ShaderRecord *, const ShaderRecord *,
                        bool>,
             std::deque<Variant>>
        objectShapes_;
    std::uint32_t objects_ = 0; ///< Sets of shapes that stand together.
};

} // namespace

RayGeometry buildShapes(DeclaredWorld &declared, SceneState &state, ShaderLibrary &library,
                        DiagnosticSink &sink) {
    return ShapeBuilder(declared, state, library, sink).build();
}

} // namespace candela
