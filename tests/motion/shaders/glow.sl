/* Shines alike to all sides. */
surface glow(float radiance = 1;) {
    Oi = Os;
    Ci = Os * Cs * radiance;
}
