/* The time that a point is seen at. */
surface moment() {
    Oi = Os;
    Ci = time;
}
