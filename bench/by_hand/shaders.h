// SPDX-License-Identifier: Apache-2.0
// The yardsticks: what one would write by hand for a level's registers. They read what compiled
// shaders read and write what those write, all lanes of whole registers, with plain stores; they
// know of no masks, light categories or arrays.
#pragma once

#include "by_hand.h"
#include "noise.h"
#include "spline.h"

namespace candela::bench {
namespace {

const float *const *planes(const ShaderArgs &args, ShaderInput which) {
    return args.inputs + int(which);
}

/// The parameters of the lanes from a point on: one block for all, or a block a lane.
class Parameters {
public:
    Parameters(const ShaderArgs &args, int at)
        : base_(args.parameters), offset_(args.parameterOffset + at),
          shared_(allEqual(load(offset_), *offset_)) {}
    Floats operator[](int slot) const {
        if (shared_)
            return all(base_[*offset_ + slot]);
        Floats values{};
        for (int k = 0; k < lanes; ++k)
            values[k] = base_[offset_[k] + slot];
        return values;
    }
    Three color(int slot) const { return {{(*this)[slot], (*this)[slot + 1], (*this)[slot + 2]}}; }

private:
    const float *base_;
    const std::int32_t *offset_;
    bool shared_;
};

/// The first three outputs are Ci, the next Oi.
void put(const ShaderArgs &args, int at, const Three &Ci, const Three &Oi) {
    store(args.outputs, at, Ci);
    store(args.outputs + 3, at, Oi);
}

Three ambient(const ShaderArgs &args, int at) {
    return args.ambient ? load(args.ambient, at) : Three{};
}

/// The unit normal on the side that is seen.
Three facingNormal(const ShaderArgs &args, int at) {
    const Three N = normalize(load(planes(args, ShaderInput::N), at));
    const Floats seen =
        dot(load(planes(args, ShaderInput::I), at), load(planes(args, ShaderInput::Ng), at));
    Three facing;
    for (int k = 0; k < 3; ++k)
        facing[k] = seen > 0.0f ? -N[k] : N[k];
    return facing;
}

Three diffuse(const ShaderArgs &args, int at, const Three &normal) {
    Three sum{};
    for (int sample = 0; sample < args.sampleCount; ++sample) {
        const int row = sample * args.sampleStride + at;
        const Floats cosine = greater(dot(normalize(load(args.sampleL, row)), normal), Floats{});
        sum = sum + load(args.sampleCl, row) * cosine;
    }
    return sum;
}

void constant(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes) {
        const Three Os = load(planes(*args, ShaderInput::Os), at);
        put(*args, at, Os * load(planes(*args, ShaderInput::Cs), at), Os);
    }
}

void grey(const ShaderArgs &args, int at, Floats value) {
    put(args, at, {{value, value, value}}, load(planes(args, ShaderInput::Os), at));
}

void oneNoise(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes)
        grey(*args, at, noise(load(planes(*args, ShaderInput::P), at) * all(8)));
}

void fbm(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes) {
        const Three P = load(planes(*args, ShaderInput::P), at);
        Floats sum{};
#pragma GCC unroll 2
        for (int octave = 0; octave < 8; ++octave)
            sum = fused(noise(P * all(float(8 << octave))), all(.5f / float(1 << octave)), sum);
        grey(*args, at, sum);
    }
}

void marble(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes) {
        const Three P = load(planes(*args, ShaderInput::P), at) * Parameters(*args, at)[0];
        Floats turbulence{};
#pragma GCC unroll 2
        for (int octave = 0; octave < 6; ++octave) {
            const Floats ridge = .5f - noise(P * all(float(1 << octave)));
            turbulence =
                fused(ridge < 0.0f ? -ridge : ridge, all(1 / float(1 << octave)), turbulence);
        }
        const Floats x = smaller(greater(4.0f * turbulence - .5f, Floats{}), all(1));
        const Three Os = load(planes(*args, ShaderInput::Os), at);
        put(*args, at, Os * veins(x), Os);
    }
}

void matte(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes) {
        const Parameters given(*args, at);
        const Three facing = facingNormal(*args, at);
        const Three light = ambient(*args, at) * given[0] + diffuse(*args, at, facing) * given[1];
        const Three Os = load(planes(*args, ShaderInput::Os), at);
        put(*args, at, Os * load(planes(*args, ShaderInput::Cs), at) * light, Os);
    }
}

void plastic(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes) {
        const Parameters given(*args, at);
        const Three facing = facingNormal(*args, at);
        const Three toEye = normalize(load(planes(*args, ShaderInput::I), at)) * all(-1);
        const Floats exponent = 8.0f / given[3];
        Three body{}, coat{};
        for (int sample = 0; sample < args->sampleCount; ++sample) {
            const int row = sample * args->sampleStride + at;
            const Three L = normalize(load(args->sampleL, row)), Cl = load(args->sampleCl, row);
            const Floats cosine = greater(dot(L, facing), Floats{});
            const Floats towards = greater(dot(facing, normalize(L + toEye)), Floats{});
            const Floats peak = power(towards, exponent);
            body = body + Cl * cosine;
            coat = coat + Cl * (cosine > 0.0f ? peak : Floats{});
        }
        body = ambient(*args, at) * given[0] + body * given[1];
        const Three Os = load(planes(*args, ShaderInput::Os), at);
        const Three Cs = load(planes(*args, ShaderInput::Cs), at);
        put(*args, at, Os * (Cs * body + given.color(4) * given[2] * coat), Os);
    }
}

/// From 0 at `low` to 1 at low + 1 / slope.
Floats smoothStep(Floats low, Floats slope, Floats x) {
    const Floats t = smaller(greater((x - low) * slope, Floats{}), all(1));
    return t * t * (3.0f - 2.0f * t);
}

void brick(const ShaderArgs *args) {
    for (int at = 0; at < args->count; at += lanes) {
        const Parameters given(*args, at);
        const Floats width = given[2], height = given[3], joint = given[4], blur = given[5];
        const Floats pitch = width + joint, rise = height + joint, steep = 1.0f / blur;
        const Floats s = load(planes(*args, ShaderInput::s)[0] + at);
        const Floats t = load(planes(*args, ShaderInput::t)[0] + at);
        const Floats row = floor(t / rise), up = t - row * rise;
        const Floats shifted = s + .5f * pitch * (row - 2.0f * floor(row * .5f));
        const Floats column = floor(shifted / pitch), along = shifted - column * pitch;
        const Floats inside =
            smoothStep(Floats{}, steep, along) * (1.0f - smoothStep(width - blur, steep, along)) *
            smoothStep(Floats{}, steep, up) * (1.0f - smoothStep(height - blur, steep, up));
        const Floats tone = .7f + .3f * cellNoise(column, row);
        const Floats rough =
            1.0f - given[6] * noise(load(planes(*args, ShaderInput::P), at) * all(40));
        const Three mortar = given.color(7), Cs = load(planes(*args, ShaderInput::Cs), at);
        Three body;
        for (int c = 0; c < 3; ++c)
            body[c] = mixed(mortar[c], Cs[c] * tone, inside);
        const Three facing = facingNormal(*args, at);
        const Three light = ambient(*args, at) * given[0] + diffuse(*args, at, facing) * given[1];
        const Three Os = load(planes(*args, ShaderInput::Os), at);
        put(*args, at, Os * (body * rough) * light, Os);
    }
}

constexpr HandShader table[] = {constant, oneNoise, fbm, matte, plastic, marble, brick};

} // namespace
} // namespace candela::bench
