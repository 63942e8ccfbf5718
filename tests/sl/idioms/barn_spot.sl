/* SPDX-License-Identifier: Apache-2.0 */
/* A spotlight with four barn doors and a soft edge at each. */
light barn_spot(
    float intensity = 1;
    color lightcolor = 1;
    point from = point "shader" (0,0,0);
    point to = point "shader" (0,0,1);
    float coneangle = radians(45);
    float conedeltaangle = radians(3);
    float doorleft = -.5, doorright = .5, doortop = .4, doorbottom = -.4, soft = .05;
    string __category = "key";
    output uniform float __nonspecular = 0;)
{
    uniform vector axis = normalize(to - from);
    uniform vector side = normalize(vector "shader" (1, 0, 0));
    uniform vector up = axis ^ side;
    illuminate(from, axis, coneangle) {
        vector dir = L / (L . axis);
        float x = dir . side, y = dir . up;
        float doors = smoothstep(doorleft - soft, doorleft, x) * (1 - smoothstep(doorright, doorright + soft, x))
                    * smoothstep(doorbottom - soft, doorbottom, y) * (1 - smoothstep(doortop, doortop + soft, y));
        float cosangle = (L . axis) / length(L);
        float cone = smoothstep(cos(coneangle), cos(coneangle - conedeltaangle), cosangle);
        Cl = intensity * lightcolor * doors * cone / (L . L);
    }
}
