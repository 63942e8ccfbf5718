/* SPDX-License-Identifier: Apache-2.0 */
/* Sea, coast, land and ice by fractal height, clouds above. */
surface planet_globe(float sealevel = .05, freq = 2, octaves = 7, icelatitude = .75;
                     color deep = color(.02, .05, .2), shallow = color(.05, .2, .4),
                           green = color(.1, .25, .05), rock = color(.35, .3, .25);
                     uniform string space = "shader")
{
    point PP = transform(space, P) * freq;
    uniform float i;
    float sum = 0, amp = 1, scale = 1;
    for (i = 0; i < octaves; i += 1) {
        sum += amp * (2 * float noise(PP * scale) - 1);
        amp *= .5;
        scale *= 2.1;
    }
    float latitude = abs(zcomp(normalize(transform(space, P))));
    color land = mix(green, rock, smoothstep(.1, .5, sum));
    color C = sum < sealevel ? mix(deep, shallow, smoothstep(-.4, sealevel, sum)) : land;
    if (latitude + .1 * sum > icelatitude)
        C = color(.9, .95, 1);
    float cloud = smoothstep(.1, .5, float noise(PP * 1.7 + 20) + .5 * float noise(PP * 5) - .8);
    C = mix(C, color 1, cloud);
    Oi = Os;
    Ci = Os * C * diffuse(faceforward(normalize(N), I));
}
