/* SPDX-License-Identifier: Apache-2.0 */
/* A picture thrown from a point; the texture of the slide is procedural where no file is named. */
light slide_projector(float intensity = 1, fieldofview = PI / 16; color lightcolor = 1;
                      point from = point "shader" (0,0,0), to = point "shader" (0,0,1);
                      point up = point "shader" (0,1,0); string slidename = "")
{
    uniform vector relT, relU, relV;
    uniform float spread = 1 / tan(fieldofview / 2);
    relT = normalize(to - from);
    relU = relT ^ (up - from);
    relV = normalize(relT ^ relU);
    relU = relV ^ relT;
    illuminate(from, relT, atan(1.4142136 / spread)) {
        varying float Pt = L . relT, Pu = L . relU, Pv = L . relV;
        varying float sloc = spread * Pu / Pt, tloc = spread * Pv / Pt;
        if (abs(sloc) < 1 && abs(tloc) < 1) {
            sloc = sloc * .5 + .5;
            tloc = .5 - tloc * .5;
            if (slidename != "")
                Cl = texture(slidename, sloc, tloc);
            else
                Cl = mod(floor(sloc * 8) + floor(tloc * 8), 2);
        } else
            Cl = 0;
        Cl *= intensity * lightcolor / (L . L);
    }
}
