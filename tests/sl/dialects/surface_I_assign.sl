surface a() { I = normalize(I); Ci = specular(normalize(N), -I, .1); }
