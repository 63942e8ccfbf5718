/* A deformation. */
transformation bent(float by = .2; string axis = "x";)
{
    point p = transform("shader", P);
    float far = axis == "x" ? xcomp(p) : zcomp(p);
    p = rotate(p, by * far, point(0, 0, 0), point(0, 1, 0)) + by * noise(p) * vector(0, 1, 0);
    P = transform("shader", "current", p);
}
