// SPDX-License-Identifier: Apache-2.0
// The yardstick: what one would write by hand for AVX-512, with the noise inlined. Compiled for
// x86-64-v4.
#include "shading_functions.h"

#include "language/runtime/noise_level.h"

#include <immintrin.h>

namespace candela::bench {

static WideFloats load(const float *from) { return WideFloats(_mm512_loadu_ps(from)); }
static void store(float *to, WideFloats x) { _mm512_storeu_ps(to, __m512(x)); }
static WideFloats root(WideFloats x) { return WideFloats(_mm512_sqrt_ps(__m512(x))); }
static const float *input(const ShaderArgs &args, ShaderInput which, int k) {
    return args.inputs[int(which) + k];
}

void constantByHand(const ShaderArgs *args) {
    const float *Cs[3], *Os[3];
    float *Ci[3];
    for (int k = 0; k < 3; ++k) {
        Cs[k] = input(*args, ShaderInput::Cs, k);
        Os[k] = input(*args, ShaderInput::Os, k);
        Ci[k] = args->outputs[k];
    }
    for (int i = 0; i < args->count; i += 16) {
        WideFloats color[3];
        for (int k = 0; k < 3; ++k)
            color[k] = load(Cs[k] + i) * load(Os[k] + i);
        for (int k = 0; k < 3; ++k)
            store(Ci[k] + i, color[k]);
    }
}

static void normalize(WideFloats *a) {
    const WideFloats size = root(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    const WideFloats inverse = 1.0f / (size == 0.0f ? WideFloats{} + 1.0f : size);
    for (int k = 0; k < 3; ++k)
        a[k] *= inverse;
}

void matteByHand(const ShaderArgs *args) {
    for (int i = 0; i < args->count; i += 16) {
        WideFloats N[3], I[3], sum[3] = {};
        for (int k = 0; k < 3; ++k) {
            N[k] = load(input(*args, ShaderInput::N, k) + i);
            I[k] = load(input(*args, ShaderInput::I, k) + i);
        }
        normalize(N);
        const WideFloats towards = I[0] * N[0] + I[1] * N[1] + I[2] * N[2];
        for (int k = 0; k < 3; ++k)
            N[k] = towards > 0.0f ? -N[k] : N[k];
        for (int s = 0; s < args->sampleCount; ++s) {
            const int row = s * args->sampleStride + i;
            WideFloats L[3];
            for (int k = 0; k < 3; ++k)
                L[k] = load(args->sampleL[k] + row);
            normalize(L);
            const WideFloats raw = N[0] * L[0] + N[1] * L[1] + N[2] * L[2];
            const WideFloats cosine = raw > 0.0f ? raw : WideFloats{};
            for (int k = 0; k < 3; ++k)
                sum[k] += load(args->sampleCl[k] + row) * cosine;
        }
        const __m512i offsets = _mm512_loadu_si512(args->parameterOffset + i);
        const WideFloats Kd = WideFloats(_mm512_i32gather_ps(offsets, args->parameters, 4));
        for (int k = 0; k < 3; ++k)
            store(args->outputs[k] + i, load(input(*args, ShaderInput::Cs, k) + i) * sum[k] * Kd);
    }
}

static WideFloats noise(const WideFloats *P, float frequency) {
    Axis<WideFloats> axes[3];
    for (int k = 0; k < 3; ++k)
        axes[k] = makeAxis<WideFloats, false>(P[k] * frequency, WideFloats{}, axisFactors[k]);
    return blend<WideFloats, 3, 0, 2, 0>(axes, hashCorners<WideFloats, 3>(axes)).value + 0.5f;
}

void marbleByHand(const ShaderArgs *args) {
    for (int i = 0; i < args->count; i += 16) {
        const __m512i offsets = _mm512_loadu_si512(args->parameterOffset + i);
        const WideFloats frequency = WideFloats(_mm512_i32gather_ps(offsets, args->parameters, 4));
        WideFloats P[3], sum{};
        for (int k = 0; k < 3; ++k)
            P[k] = load(input(*args, ShaderInput::P, k) + i) * frequency;
        float octave = 1;
        for (int k = 0; k < marbleOctaves; ++k, octave *= 2) {
            const WideFloats d = 0.5f - noise(P, octave);
            sum += (d < 0.0f ? -d : d) / octave;
        }
        const WideFloats raw = sum * 4.0f - 0.5f;
        const WideFloats above = raw > 0.0f ? raw : WideFloats{};
        const WideFloats x = (above < 1.0f ? above : WideFloats{} + 1.0f) * float(marbleKnots - 3);
        const WideFloats whole = Lanes<WideFloats>::floor(x);
        const WideFloats segment =
            whole < float(marbleKnots - 4) ? whole : WideFloats{} + float(marbleKnots - 4);
        const WideFloats t = x - segment;
        const WideBits index = Lanes<WideFloats>::integerBits(segment);
        for (int channel = 0; channel < 3; ++channel) {
            WideFloats p[4];
            for (int k = 0; k < 4; ++k)
                p[k] = WideFloats(
                    _mm512_i32gather_ps(__m512i(index + unsigned(k)), marbleColors[channel], 4));
            const WideFloats a = -0.5f * p[0] + 1.5f * p[1] - 1.5f * p[2] + 0.5f * p[3];
            const WideFloats b = p[0] - 2.5f * p[1] + 2.0f * p[2] - 0.5f * p[3];
            const WideFloats c = -0.5f * p[0] + 0.5f * p[2];
            store(args->outputs[channel] + i, ((a * t + b) * t + c) * t + p[1]);
        }
    }
}

} // namespace candela::bench
