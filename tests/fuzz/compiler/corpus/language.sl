/* What the shaders of the library leave out: functions of all sorts, arrays, nested control. */
#define SQR(x) ((x) * (x))
#define LERP(a, b, t) mix(a, b, t)
#if CANDELA > 0 && defined(SQR)
float turbulence(point p; uniform float octaves) {
    float sum = 0, i;
    for (i = 1; i < octaves; i += 1)
        sum += abs(.5 - noise(p * i)) / i;
    return sum;
}
#else
#error "no"
#endif
untyped(color c; output float r[]) { r[0] = c[1]; return SQR(c); }
void swap(output float a, b;) { float k = a; a = b; b = k; }
color ramp(float x; color knots[4]) {
    if (x < 0) return knots[0];
    return spline(x, knots);
}
surface language(float Kd = 0.4, exp = 2; color tint = color "hsv" (.1, .2, 1);
    uniform point from = point "world" (0, 0, 0); string mode = "fast";
    matrix turn = 1; output varying color aov[2] = {0, 1}; varying float bump = 0;)
{
    vector R = reflect(I, normalize(N));
    color C = 0, knots[4] = {0, .3, color(1, 0, 0), 1};
    float k[4] = {1, 2, 3, 4}, d = 0, e = 1;
    uniform float i, j;
    for (i = 0; i < 4; i += 1) {
        for (j = 0; j < 4; j += 1) {
            if (j > i) break;
            if (mod(i + j, 3) == 1) continue 2;
            k[i] += k[j] * u;
        }
        k[floor(v * 4)] = i;
    }
    illuminance("a&-b", P, 2, N, 180, 0, Kd, R, 180, exp, 1 - Kd) {
        if (L . N < 0 || !(Kd >= 1)) continue;
        else C += Cl * pow(max(0, R . L), exp);
    }
    illuminance(P, N, PI / 2) {
        float w = 3;
        C -= Cl;
        while (w > 1) { w -= 1; if (u > v) break; }
    }
    float inner(float x) { extern color C; return x + comp(C, 0); }
    swap(d, e);
    while (d > .1) d *= .5;
    aov[1] = untyped(C, k) + inner(u ? 1 : turbulence(transform("shader", P), 4));
    matrix m = (1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1);
    C *= determinant(m * turn) + k[2];
    if (mode == "fast" && match("f.*t", mode)) printf("%c %f\n", C, exp(1));
    setcomp(C, 1, LERP(xcomp(P), k[3], smoothstep(0, 1, t)));
    Oi = spline(u, k[0], .2, k[1], .9, 1);
    float kr, kt;
    fresnel(I, N, 1 / 1.5, kr, kt);
    Ci = Oi * C * tint * (from . P) + kr * ramp(bump, knots) + kt * color(P ^ R);
}
