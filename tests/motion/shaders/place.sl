/* A point that is a parameter lies in "shader" space: how far P is from it. */
surface place(point centre = point "shader" (0, 0, 0);) {
    Oi = Os;
    Ci = Os * distance(P, centre);
}
