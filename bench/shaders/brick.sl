/* SPDX-License-Identifier: Apache-2.0
   A wall of bricks, each of a tone of its own and rough, in mortar; diffuse. */
surface brick(float Ka = 1;
              float Kd = 1;
              float width = .25;    /* of a brick, in s */
              float height = .08;   /* in t */
              float joint = .01;    /* between bricks */
              float blur = .002;    /* of edges */
              float grain = .3;     /* how much noise shows */
              color mortar = .6;)
{
    float pitch = width + joint, rise = height + joint;
    float row = floor(t / rise);
    float up = t - row * rise;
    float shifted = s + .5 * pitch * mod(row, 2);
    float column = floor(shifted / pitch);
    float along = shifted - column * pitch;

    float inside = smoothstep(0, blur, along) * (1 - smoothstep(width - blur, width, along)) *
                   smoothstep(0, blur, up) * (1 - smoothstep(height - blur, height, up));
    float tone = .7 + .3 * float cellnoise(column, row);
    float rough = 1 - grain * float noise(40 * P);
    color body = mix(mortar, Cs * tone, inside) * rough;

    normal facing = faceforward(normalize(N), I);
    Oi = Os;
    Ci = Os * body * (Ka * ambient() + Kd * diffuse(facing));
}
