// SPDX-License-Identifier: Apache-2.0
#include "world/displacement/displacement_builder.h"

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

const ShaderInstance *
DisplacementBuilder::instanceOf(const std::shared_ptr<const ShaderRecord> &record,
                                const std::set<std::string> &variables) {
    auto [place, isNew] = instances_.try_emplace({record.get(), variables});
    if (isNew) {
        place->second =
            library_.instance(ShaderKind::Displacement, *record, options_, rule_, variables);
        if (place->second && prepared_.insert(place->second->code.get()).second)
            prepare(*place->second->code);
    }
    return place->second ? &*place->second : nullptr;
}

std::shared_ptr<const ShaderDisplacement>
DisplacementBuilder::make(const ShaderInstance &shader,
                          const std::shared_ptr<const ShaderRecord> &record,
                          const DisplacedThing &thing) {
    bounds_.push_back(std::make_shared<DisplacementBounds>(*thing.attributes, record,
                                                           thing.currentFromShape, systems_));
    return std::make_shared<const ShaderDisplacement>(shader, thing, camera_, bounds_.back());
}

std::shared_ptr<const ShaderDisplacement>
DisplacementBuilder::byDisplacement(const DisplacedThing &thing) {
    const std::shared_ptr<const ShaderRecord> &record = thing.attributes->displacement;
    if (!record)
        return nullptr;
    const ShaderInstance *shader = instanceOf(record, overridingNames(*thing.surface));
    if (!shader || (!shader->code->displacement().movesP && !shader->code->displacement().setsN))
        return nullptr;
    return make(*shader, record, thing);
}

std::shared_ptr<const ShaderDisplacement>
DisplacementBuilder::bySurface(const DisplacedThing &thing, const ShaderInstance &shader) {
    if (prepared_.insert(shader.code.get()).second)
        prepare(*shader.code);
    return make(shader, thing.attributes->surface, thing);
}

void DisplacementBuilder::report(DiagnosticSink &sink) const {
    DisplacementBounds::report(bounds_, sink);
}

bool displaceAlike(const Surface &surface, const ShaderDisplacement &one,
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
    const std::size_t names = direct ? mesh.triangles.size() : mesh.vertexUv.size();
    for (std::size_t k = 0; k < std::min(names, most); ++k) {
        const std::size_t name = k * names / std::min(names, most);
        piece.push_back(direct ? std::uint32_t(name) : 0);
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

} // namespace candela
