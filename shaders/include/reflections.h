// SPDX-License-Identifier: Apache-2.0
// What is seen in mirrors, under the names that the shaders of Advanced RenderMan use: by maps
// where there is one, else by rays.
#ifndef REFLECTIONS_H
#define REFLECTIONS_H

#define ENVPARAMS envname, envspace, envrad
#define DECLARE_ENVPARAMS \
    string envname, envspace; \
    uniform float envrad
#define DECLARE_DEFAULTED_ENVPARAMS \
    string envname = "", envspace = "world"; \
    uniform float envrad = 0

/// A flat picture of what the surface mirrors, taken from where the eye is. alpha: how much of it
/// is there.
color ReflMap(string reflname; point p; float blur; output float alpha) {
    point onPicture = transform("NDC", p);
    float x = xcomp(onPicture), y = ycomp(onPicture);
    alpha = float texture(reflname[3], x, y, "blur", blur, "fill", 1);
    return color texture(reflname, x, y, "blur", blur);
}

/// An environment map in envspace; with a radius above 0 a map that lies on a sphere of that size
/// about its origin, so that what is near moves as it should.
color Environment(string envname, envspace; uniform float envrad; point p; vector r; float blur;
                  output float alpha) {
    vector way = normalize(vtransform(envspace, r));
    if (envrad > 0) {
        vector from = vector transform(envspace, p);
        float along = from . way;
        float reach = along * along + envrad * envrad - from . from;
        if (reach > 0)
            way = from + way * (sqrt(reach) - along);
    }
    alpha = float environment(envname[3], way, "blur", blur, "fill", 1);
    return color environment(envname, way, "blur", blur);
}

/// Kr times what p sees along r.
color SampleEnvironment(point p; vector r; float Kr, blur; DECLARE_ENVPARAMS) {
    color seen = 0;
    if (Kr > 0.0001) {
        float alpha = 1;
        if (envname == "")
            seen = trace(p, r);
        else if (envspace == "NDC")
            seen = ReflMap(envname, p, blur, alpha);
        else
            seen = Environment(envname, envspace, envrad, p, r, blur, alpha);
    }
    return Kr * seen;
}

#endif
