imager a() { Ci = mix(color(s,t,0), color(u,v,1), alpha); }
