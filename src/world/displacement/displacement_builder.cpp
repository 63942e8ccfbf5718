// SPDX-License-Identifier: Apache-2.0
#include "world/displacement/displacement_builder.h"

#include "world/geometry/moved_displacement.h"
#include "world/geometry/moved_surface.h"

#include <algorithm>

namespace candela {

DisplacementBuilder::DisplacementBuilder(ShaderLibrary &library, const Options &options,
                                         ir::LightRule rule,
                                         const std::map<std::string, Matrix4> &systems,
                                         const Camera &camera)
    : library_(library), options_(options), rule_(rule), systems_(systems), camera_(camera) {}

/// Compiles it, and all that is new besides.
void DisplacementBuilder::prepare(const ShaderCode &code) {
    library_.makeReady();
    for (const auto &known : library_.all())
        if (known.get() == &code) {
            DiagnosticList silent; // What is missing is said when all shaders are bound.
            known->bindSpaces(systems_, silent);
        }
}

const ShaderInstance *DisplacementBuilder::instanceOf(ShaderKind kind, const ShaderRecord *record,
                                                      const DisplacedThing &thing) {
    if (!record)
        return nullptr;
    const Attributes &attributes = *thing.attributes;
    const OtherShaders others{attributes.surface.get(), attributes.displacement.get(),
                              attributes.atmosphere.get(), attributes.interior.get(),
                              attributes.exterior.get()};
    const std::set<std::string> variables = overridingNames(*thing.surface);
    auto [place, isNew] = instances_.try_emplace({record, others, variables});
    std::optional<ShaderInstance> &instance = place->second;
    if (isNew) {
        instance = library_.instance(kind, *record, options_, rule_, variables, others);
        if (instance) {
            const ir::DisplacementFacts &facts = instance->code->displacement();
            if (!facts.movesP && !facts.setsN)
                instance.reset();
        }
    }
    return instance ? &*instance : nullptr;
}

/// The next stage, which sees what those before have made of the thing.
void DisplacementBuilder::add(const ShaderInstance &shader,
                              const std::shared_ptr<const ShaderRecord> &record,
                              DisplacedThing thing, DisplacedStages &displaced) {
    if (prepared_.insert(shader.code.get()).second)
        prepare(*shader.code);
    bounds_.push_back(std::make_shared<DisplacementBounds>(*thing.attributes, record,
                                                           thing.currentFromShape, systems_));
    thing.surface = displaced.surface;
    displaced.stages.push_back(
        std::make_shared<const ShaderDisplacement>(shader, thing, camera_, bounds_.back()));
    displaced.surface = std::make_shared<MovedSurface>(displaced.surface, displaced.stages.back());
}

DisplacedStages DisplacementBuilder::displace(const DisplacedThing &thing,
                                              const std::optional<ShaderInstance> &moving) {
    DisplacedStages displaced{thing.surface, thing.surface, nullptr, {}};
    std::shared_ptr<const Surface> beforeLast = thing.surface;
    const Attributes &attributes = *thing.attributes;
    for (const auto &[kind, record] :
         {std::pair{ShaderKind::Transformation, attributes.deformation},
          std::pair{ShaderKind::Displacement, attributes.displacement}})
        if (const ShaderInstance *shader = instanceOf(kind, record.get(), thing)) {
            beforeLast = displaced.surface;
            add(*shader, record, thing, displaced);
        }
    if (moving) {
        beforeLast = displaced.surface;
        add(*moving, attributes.surface, thing, displaced);
    }
    const auto moves = [](const auto &stage) { return stage->movesPoints(); };
    if (std::ranges::none_of(displaced.stages, moves))
        return displaced;
    const auto &last = displaced.stages.back();
    if (last->movesPoints()) {
        displaced.surface = beforeLast, displaced.mover = last;
        return displaced;
    }
    const bool knowsSlopes = std::ranges::all_of(displaced.stages, [&](const auto &stage) {
        return !stage->movesPoints() || stage->knowsSlopes();
    });
    displaced.mover = std::make_shared<MovedDisplacement>(displaced.surface, last, knowsSlopes);
    displaced.surface = displaced.own;
    return displaced;
}

void DisplacementBuilder::report(DiagnosticSink &sink) const {
    DisplacementBounds::report(bounds_, sink);
}

static bool displaceAlike(const Surface &surface, const ShaderDisplacement &one,
                          const ShaderDisplacement &other) {
    if (one.readsOtherSpaces() || other.readsOtherSpaces())
        return false;
    const Vec3 extent = surface.bound().extent();
    const float size = std::max({extent.x, extent.y, extent.z});
    const DicedMesh mesh = surface.dice({size / 4, size / 100});
    constexpr std::size_t most = 64;
    std::vector<std::uint32_t> piece;
    std::vector<float> u, v;
    const bool direct = mesh.vertexUv.empty();
    const std::vector<std::uint32_t> vertexPiece = mesh.piecesOfVertices();
    const std::size_t names = direct ? mesh.triangles.size() : mesh.vertexUv.size();
    for (std::size_t k = 0; k < std::min(names, most); ++k) {
        const std::size_t name = k * names / std::min(names, most);
        piece.push_back(direct ? std::uint32_t(name) : vertexPiece[name]);
        u.push_back(direct ? 0.3f : mesh.vertexUv[name][0]);
        v.push_back(direct ? 0.2f : mesh.vertexUv[name][1]);
    }
    const int n = int(piece.size());
    std::vector<float> values(15 * piece.size());
    const auto planes = [&](int first) {
        float *x = values.data() + first * n;
        return Vec3Planes{x, x + n, x + 2 * n};
    };
    SurfaceAnswer start, oneSays, otherSays;
    start.P = planes(0), oneSays.P = planes(3), oneSays.N = planes(6);
    otherSays.P = planes(9), otherSays.N = planes(12);
    const SurfaceQuery query{n, piece.data(), u.data(), v.data()};
    surface.evaluate(query, start);
    one.displace(query, oneSays);
    other.displace(query, otherSays);
    for (int k = 0; k < n; ++k) {
        const float moved = length(oneSays.P.get(k) - start.P.get(k));
        constexpr float rounding = 1e-5f, share = 1e-3f;
        if (!(length(oneSays.P.get(k) - otherSays.P.get(k)) <= rounding * size + share * moved))
            return false;
        const Vec3 N = normalize(oneSays.N.get(k)) - normalize(otherSays.N.get(k));
        if (!(length(N) <= 10 * share))
            return false;
    }
    return true;
}

bool displaceAlike(const DisplacedStages &one, const DisplacedStages &other) {
    if (one.stages.size() != other.stages.size())
        return false;
    for (std::size_t k = 0; k < one.stages.size(); ++k)
        if (!displaceAlike(*one.own, *one.stages[k], *other.stages[k]))
            return false;
    return true;
}

} // namespace candela
