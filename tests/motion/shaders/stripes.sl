/* Stripes that a coordinate system tells: an object takes them along where it moves with that. */
surface stripes(string space = "shader"; float width = .05;) {
    point Q = transform(space, P);
    Oi = Os;
    Ci = Os * mod(floor(xcomp(Q) / width), 2);
}
