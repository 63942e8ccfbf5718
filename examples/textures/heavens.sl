/* SPDX-License-Identifier: Apache-2.0
   A picture of all directions, by longitude (s) and latitude (t, from the top): a sky with a low
   sun and thin clouds over hills. */
surface heavens(float sunlongitude = .62, sunlatitude = .43;)
{
    float longitude = 2 * PI * s, latitude = PI * (.5 - t);
    point way = point (cos(longitude) * cos(latitude), sin(longitude) * cos(latitude),
                       sin(latitude));
    float height = zcomp(way), clouds = 0, size = 1;
    float octave;
    for (octave = 0; octave < 5; octave += 1) {
        clouds += noise(3 * way / (size * (.25 + abs(height)))) * size;
        size /= 2;
    }
    color sky = mix(color (.95, .72, .5), color (.12, .28, .62), pow(max(height, 0), .45));
    sky = mix(sky, color (1, .9, .82), .6 * smoothstep(1.05, 1.45, clouds));
    vector sun = vector (cos(2 * PI * sunlongitude) * sin(PI * sunlatitude),
                         sin(2 * PI * sunlongitude) * sin(PI * sunlatitude),
                         cos(PI * sunlatitude));
    sky += color (6, 4.6, 3) * smoothstep(.9985, .9995, vector way . sun);
    float hills = .05 * noise(6 * point (xcomp(way), ycomp(way), 0));
    color earth = color (.1, .085, .07) * (.6 + .8 * noise(9 * way));

    Oi = 1;
    Ci = mix(earth, sky, smoothstep(hills - .004, hills + .004, height));
}
