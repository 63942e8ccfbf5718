// SPDX-License-Identifier: Apache-2.0
// Steps that several stages share.
#pragma once

#include "light/path/roulette.h"
#include "light/path/wave.h"

namespace candela {

/// weight[i] = 0 of light[i] (index + 1) that is off for the vertex that the ray left, or that its
/// shader hears by samples of the light alone: directions bring nothing of those.
void leaveOutUnheard(const Scene &, int count, const std::int32_t *light, const RayOrigins &left,
                     float *weight);
/// LightQuery::scattered of the vertices that the rays left.
void markHeard(const Scene &, int count, const RayOrigins &left, float *heard);
/// Draws one of the vertices' dimension pairs into chunk.numbers.
void drawNumbers(PathWave &, VertexPair);
/// True where all vertices have numbers of lightChoicePair, roulette's among them, from the start.
bool drawsLightChoice(const PathWave &);
/// chunk.N, of vertices whose directions are drawn from the mixture.
void stateLightNormals(VertexChunk &, const ConeMixture &);
/// True if slot()[i] = slot()[0] + i.
bool slotsAreConsecutive(const PathWave &);
/// Tells of a value that a shader has given, and which is not finite, at vertex i of the chunk.
void reportNonFinite(PathWave &, int i, const std::string &shader);
/// What the rays that met the vertices were in, and carried of it.
void takeMedia(PathWave &);
/// The wave's, which is made when it is wanted.
Crossing &crossingOf(PathWave &);
/// What paths that have met nothing yet are in: air.
void beginMedia(int count, PathMedia &);
/// What the `count` paths that append() has put at next[first] on are in, and what opacity is worth
/// to those that go straight on.
void leaveMedia(PathWave &, const ConstVec3Planes &direction, int count, int first);
/// Raises way.brightest where a path goes straight on to opacity that counts, dark as it is.
void weighOpacityBehind(PathWave &);
/// Adds to a channel what a shader has left at the vertices that the camera sees, as far as it sees
/// them: of lanes with a bit in `active`, 16 a word; null = all.
void addSeen(PathWave &, const ShaderChannelPlane &, const float *value,
             const std::uint16_t *active);
/// Numbers for events of one direction and for roulette between them; must come first. The
/// importance of finite lobes is null where they are not followed.
void beginEvents(PathWave &, const float *finiteTotal);
/// Numbers of their own for paths that go on along the events of a kind, and for their roulette.
void numberKind(PathWave &, int kind);
/// The paths go on along each event of one direction that chunk.events has; those of small
/// throughput play roulette.
void followEvents(PathWave &, RouletteThresholds);
/// Of rays along directions of these densities (RayBatch::spread).
void spreadOfDirections(int count, const float *pdf, float *spread);
/// Puts the paths of vertices way.lane[0..count), which go on along chunk.events in these
/// directions, behind those in `next`.
void append(PathWave &, const ConstVec3Planes &direction, int count);

} // namespace candela
