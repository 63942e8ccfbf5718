/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    float x = filterstep(.5, s);
    x += filterstep(.5, s, "filter", "box");
    x += filterstep(.5, s, s + .1);
    x += filterstep(.5, s, "width", 2, "filter", "gaussian");
    x += filterstep(.5, s, s + .1, "filter", "catmull-rom");
    Ci = x;
    Oi = Os;
}
