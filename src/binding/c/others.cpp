// SPDX-License-Identifier: Apache-2.0
// Requests of Candela's own and of other renderers.
#include "binding/c/calls.h"

using namespace candela;
using namespace candela::c;

// clang-format off
RI_LISTED(PushFilter, name, (RtToken name), (name), pushFilter(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(PopFilter, (), popFilter(ri.at()))
RI_LISTED(Procedural2, bound, (RtToken generator, RtToken bound), (generator, bound), procedural2(ri.at(), text(generator), text(bound), ri.list(single, {n, tokens, values})))
RI_LISTED(Bxdf, handle, (RtToken name, RtToken handle), (name, handle), bxdf(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_LISTED(ShaderLayer, layer, (RtToken type, RtToken name, RtToken layer), (type, name, layer), shaderLayer(ri.at(), text(type), text(name), text(layer), ri.list(single, {n, tokens, values})))
RI_LISTED(Camera, name, (RtToken name), (name), camera(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(CameraShutter, (RtFloat opening, RtFloat closing), cameraShutter(ri.at(), {{opening, closing}}))
RI_PLAIN(ConnectShaderLayers, (RtToken type, RtToken layer1, RtToken variable1, RtToken layer2, RtToken variable2), connectShaderLayers(ri.at(), text(type), text(layer1), text(variable1), text(layer2), text(variable2)))
RI_LISTED(Displace, handle, (RtToken name, RtToken handle), (name, handle), displace(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_LISTED(DisplayFilter, handle, (RtToken name, RtToken handle), (name, handle), displayFilter(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_PLAIN(EditAttributeBegin, (RtToken name), editAttributeBegin(ri.at(), text(name)))
RI_PLAIN(EditAttributeEnd, (), editAttributeEnd(ri.at()))
RI_LISTED(EditBegin, name, (RtToken name), (name), editBegin(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(EditEnd, (), editEnd(ri.at()))
RI_LISTED(EditWorldBegin, name, (RtToken name), (name), editWorldBegin(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(EditWorldEnd, (), editWorldEnd(ri.at()))
RI_PLAIN(EnableLightFilter, (RtLightHandle light, RtToken filter, RtBoolean on), enableLightFilter(ri.at(), ri.nameOf(light), {text(filter)}, on != 0))
RI_LISTED(Integrator, handle, (RtToken name, RtToken handle), (name, handle), integrator(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_LISTED(LightFilter, handle, (RtToken name, RtToken handle), (name, handle), lightFilter(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_LISTED(MakeBrickMap, map, (RtInt count, const RtToken *clouds, RtToken map), (count, clouds, map), makeBrickMap(ri.at(), texts(count, clouds), text(map), ri.list(single, {n, tokens, values})))
RI_LISTED(MakeOcclusion, map, (RtInt count, const RtToken *pictures, RtToken map), (count, pictures, map), makeOcclusion(ri.at(), texts(count, pictures), text(map), ri.list(single, {n, tokens, values})))
RI_LISTED(Pattern, handle, (RtToken name, RtToken handle), (name, handle), pattern(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_LISTED(PixelSampleImager, name, (RtToken name), (name), pixelSampleImager(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(SampleFilter, handle, (RtToken name, RtToken handle), (name, handle), sampleFilter(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_LISTED(Shader, handle, (RtToken name, RtToken handle), (name, handle), coshader(ri.at(), text(name), {text(handle)}, ri.list(single, {n, tokens, values})))
RI_PLAIN(System, (RtToken command), system(ri.at(), text(command)))
RI_LISTED(VPAtmosphere, name, (RtToken name), (name), vpAtmosphere(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(VPInterior, name, (RtToken name), (name), vpInterior(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(VPSurface, name, (RtToken name), (name), vpSurface(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(Volume, dimensions, (RtToken type, const RtFloat *bound, const RtInt *dimensions), (type, bound, dimensions), volume(ri.at(), text(type), floats(6, bound), integers(3, dimensions), ri.list(volumeCounts(dimensions), {n, tokens, values})))
RI_PLAIN(VolumePixelSamples, (RtFloat x, RtFloat y), volumePixelSamples(ri.at(), x, y))
// clang-format on
