/* What it hears of the displacement and the volumes of its primitive. */
surface asker(float reach = 0;)
{
    float amount = 0, kept = .5, density = 0, inside = 0, outside = 0;
    color tint = 0;
    string kind = "";
    float found = displacement("amount", amount) + displacement("tint", tint);
    if (displacement("nosuch", kept) != 0 || displacement("tint", kept) != 0)
        kept = 9;
    if (displacement("kind", kind) != 0 && kind == "rough")
        found += 4;
    atmosphere("density", density);
    incident("density", outside);
    opposite("density", inside);
    Oi = 1;
    Ci = color(amount + 10 * found, density + 10 * inside + 100 * outside, kept) + tint;
}
