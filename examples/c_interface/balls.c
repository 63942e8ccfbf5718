/* SPDX-License-Identifier: Apache-2.0
 *
 * A ring of balls on a floor, by calls from C:
 *
 *     balls              renders balls.exr
 *     balls balls.rib    writes the same scene as RIB
 */
#include <math.h>
#include <ri.h>
#include <stdio.h>

enum { balls = 12 };

/* A ball of the colour that its place in the ring says. */
static void ball(int number) {
    RtColor color = {0.9f, 0.9f, 0.9f};
    color[number % 3] = 0.2f;
    RiAttributeBegin();
    RiColor(color);
    RiRotate(360.0f * number / balls, 0, 1, 0);
    RiTranslate(0, 0.3f, 1.5f);
    RiSphere(0.3f, -0.3f, 0.3f, 360, RI_NULL);
    RiAttributeEnd();
}

/* Called back for the ring: what a program makes itself need not be a file. */
static void ring(RtPointer count, RtFloat detail) {
    int i;
    (void)detail;
    for (i = 0; i < *(int *)count; ++i)
        ball(i);
}

static void floorAndRing(void) {
    static int count = balls;
    static RtPoint corners[4] = {{-3, 0, -3}, {-3, 0, 3}, {3, 0, 3}, {3, 0, -3}};
    static RtColor colors[4] = {{.5f, .5f, .5f}, {.6f, .6f, .7f}, {.7f, .7f, .8f}, {.6f, .6f, .7f}};
    static RtBound bound = {-2, 2, 0, 1, -2, 2};
    RtFloat Kd = 0.8f;
    RiSurface("matte", RI_KD, &Kd, RI_NULL);
    RiPolygon(4, RI_P, corners, RI_CS, colors, RI_NULL);
    RiProcedural(&count, bound, ring, NULL);
}

int main(int argc, char **argv) {
    RtFloat fieldOfView = 40, intensity = 9, ambient = 0.1f;
    RtPoint from = {1.5f, 3, -1.5f};
    RiBegin(argc > 1 ? argv[1] : RI_NULL);
    RiArchiveRecord(RI_COMMENT, "%d balls", balls);
    RiDisplay("balls.exr", "openexr", RI_RGBA, RI_NULL);
    RiFormat(160, 120, 1);
    RiPixelSamples(4, 4);
    RiPixelFilter(RiGaussianFilter, 2, 2);
    RiProjection(RI_PERSPECTIVE, RI_FOV, &fieldOfView, RI_NULL);
    RiTranslate(0, -0.3f, 5);
    RiRotate(-25, 1, 0, 0);
    RiWorldBegin();
    RiLightSource(RI_POINTLIGHT, RI_FROM, from, RI_INTENSITY, &intensity, RI_NULL);
    RiLightSource(RI_AMBIENTLIGHT, RI_INTENSITY, &ambient, RI_NULL);
    floorAndRing();
    RiWorldEnd();
    RiEnd();
    return RiLastError == RIE_NOERROR ? 0 : 1;
}
