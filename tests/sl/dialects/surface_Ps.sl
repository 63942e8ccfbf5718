surface a() { point PP = Ps; Ci = noise(PP); Oi = 1; }
