// SPDX-License-Identifier: Apache-2.0
// Finds shaders by name, compiles them, and makes instances: all that stands between
// `Surface "plastic" "Kd" [.3]` and code to call.
#pragma once

#include "interface/ri/scene_builder.h"
#include "language/ir/transform/light_rule.h"
#include "world/shading/filter_code.h"
#include "world/shading/instance_values.h"
#include "world/shading/shader_code.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace candela {

struct ShaderLibrarySettings {
    /// Folders in which .sl files are looked for after the RIB's own search path: --shader-path,
    /// the RIB's folder, the current folder, $CANDELA_SHADERS, the shipped library.
    std::vector<std::string> folders;
    /// Where the shaders that stand in for missing and faulty ones come from, and from nowhere
    /// else: the shipped library.
    std::vector<std::string> libraryFolders;
    JitOptions jit;
    /// Where textures are looked for after the RIB's own search path.
    std::vector<std::string> textureFolders{};
};

/// The other shaders of a primitive, which a shader may ask for their parameters; null = none.
struct OtherShaders {
    const ShaderRecord *surface = nullptr, *displacement = nullptr, *atmosphere = nullptr;
    const ShaderRecord *interior = nullptr, *exterior = nullptr;
    auto operator<=>(const OtherShaders &) const = default;
};

class ShaderLibrary : public ShaderLookup {
public:
    ShaderLibrary(ShaderLibrarySettings, DiagnosticSink &);
    ~ShaderLibrary() override;

    std::optional<std::vector<ParameterType>> parametersOf(ShaderKind, const std::string &name,
                                                           const Options &,
                                                           const SourceLocation &) override;

    /// The instance that a record describes; equal specialisations share code. `variables` are
    /// the names of numeric primitive variables at hand, which override parameters of their name.
    /// A missing or faulty shader is reported once, and the library's default surface taken in its
    /// place, whatever lies on the search path (a faulty light: nothing). A record without a name
    /// asks for that surface. `attributes` are what attribute() tells; null: nothing.
    std::optional<ShaderInstance> instance(ShaderKind, const ShaderRecord &, const Options &,
                                           ir::LightRule, const std::set<std::string> &variables,
                                           const OtherShaders & = {},
                                           const Attributes *attributes = nullptr);
    /// The record of a light itself, or of one of the library's if its shader is missing or faulty,
    /// which is reported: a scene is not left in the dark for it.
    LightRecord lightWithShader(const LightRecord &, const Options &);
    /// Of the instance of a record that has become one: all its parameters. Empty for what is
    /// missing or faulty.
    std::vector<ToldParameter> parametersTold(ShaderKind, const ShaderRecord &, const Options &,
                                              ir::LightRule);

    /// The filter shader that a record describes, with its parameters, compiled. Null if it is
    /// missing or faulty, which is reported.
    std::shared_ptr<const FilterCode> filter(const ShaderRecord &, const Options &);

    /// Compiles all specialisations that are new, on all threads. A surface for which there is no
    /// code becomes the library's default surface, a light gives no light; an error names them.
    void makeReady();
    /// What option() tells all shaders, until it is bound anew. Not to be called while any runs.
    void bindOptions(const Options &);
    /// False for the name of a shadow map that is to be had from rays instead, by those options.
    bool hasShadowMap(const std::string &name) const;
    /// Who follows the rays that shaders ask for, until it is bound anew; null: nobody, and all is
    /// clear. Not to be called while any runs.
    void bindRays(const RayAnswers *);
    /// What lightsource() tells them, by the index of the light; likewise.
    void bindLights(std::vector<std::vector<ToldParameter>>);

    /// All specialisations so far, for binding spaces and categories.
    std::vector<std::shared_ptr<ShaderCode>> all() const;
    Jit::Statistics statistics() const;
    /// What they do, of all specialisations so far: the same for the same shaders, whatever the
    /// order of their coming.
    std::string fingerprint() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace candela
