/* SPDX-License-Identifier: Apache-2.0 */
/* Light through a window of panes, by where the way to the light crosses its plane. */
light window_light(float intensity = 1; color lightcolor = color(1, .98, .9), darkcolor = color(.05, .07, .09);
                   point from = point "shader" (-4, 3, -3), to = point "shader" (0, 0, 0);
                   point in = point "shader" (0, 0, 0);
                   vector right = vector "shader" (1, 0, 0), up = vector "shader" (0, 1, 0);
                   float width = 1, height = 2, xpanes = 2, ypanes = 3, frame = .05;
                   float fuzz = .02;)
{
    vector path = to - from;
    solar(path, 0) {
        vector across = normalize(right), above = normalize(up);
        vector facing = across ^ above;
        float far = ((in - Ps) . facing) / (path . facing);
        point pane = Ps + far * path;
        float x = ((pane - in) . across) / width, y = ((pane - in) . above) / height;
        float inside = smoothstep(0, fuzz, x) - smoothstep(1 - fuzz, 1, x);
        inside *= smoothstep(0, fuzz, y) - smoothstep(1 - fuzz, 1, y);
        float px = mod(x * xpanes, 1), py = mod(y * ypanes, 1);
        inside *= smoothstep(frame, frame + fuzz, px) * smoothstep(frame, frame + fuzz, py);
        Cl = intensity * mix(darkcolor, lightcolor, inside);
    }
}
