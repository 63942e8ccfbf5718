/* A distant light with something to say. */
light tagged(string tag = "none"; float gain = 0; color tint = 0; vector to = vector "shader"(0, 0, 1);)
{
    solar (to, 0) {
        Cl = 1;
        if (tag == "loud") /* It never is. */
            Cl = gain * tint;
    }
}
