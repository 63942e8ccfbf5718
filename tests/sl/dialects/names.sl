/* SPDX-License-Identifier: Apache-2.0 */
surface a(float incident = 1; float light = 1; color surface = 1; float exp = 1; float normal = 1;
          string displacement = ""; float volume = 1; float imager = 1; float noise = 2;
          float opposite = 1; float color_ = 1; float area = 1; float output = 1;
          float distance = 1; float end = 1; float shadow = 1; float depth = 1; float filter = 3;
          float transformation = 1;)
{
    float bump = incident * light * exp * normal;
    float mix = bump + volume;
    float texture = mix;
    Ci = surface * mix * imager * noise * opposite * area * distance * end * shadow * depth *
         filter * output * texture * transformation;
    Oi = Os;
    float public = 1;
    float private = 1;
    float class = 2;
    float method = 1;
    float struct = 1;
    Ci += public + private + class + method + struct;
}
