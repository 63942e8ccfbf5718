/* As much of a colour as is said, wherever a segment ends. */
volume haze(float amount = .5; color tint = 1;) {
    Ci = mix(Ci, tint, amount);
    Oi = mix(Oi, color 1, amount);
}
