/* SPDX-License-Identifier: Apache-2.0
   Kernels by name, as PixelFilter has them, over whole pixels. */

float sincat(float x) { return x == 0 ? 1 : sin(PI * x) / (PI * x); }

/* The weight of a pixel whose centre is `distance` from the kernel's middle; `width` is the whole
   kernel's. Of a box: how much of the pixel lies in it. */
float kernelweight(string kernel; float distance, width)
{
    float x = abs(2 * distance / width); /* 1 at the rim */
    float w = 0;

    if (kernel == "box")
        w = clamp((width + 1) / 2 - abs(distance), 0, min(width, 1));
    else if (x >= 1)
        w = 0;
    else if (kernel == "triangle")
        w = 1 - x;
    else if (kernel == "gaussian")
        w = exp(-2 * x * x);
    else if (kernel == "catmull-rom") {
        float t = 2 * x;
        w = t < 1 ? (1.5 * t - 2.5) * t * t + 1 : ((-.5 * t + 2.5) * t - 4) * t + 2;
    } else if (kernel == "lanczos")
        w = sincat(3 * x) * sincat(x);
    return w;
}

/* The width of a kernel that passes over pixels one by one. */
float usualwidth(string kernel)
{
    float width = 2;

    if (kernel == "box")
        width = 1;
    else if (kernel == "catmull-rom")
        width = 4;
    else if (kernel == "lanczos")
        width = 6;
    return width;
}

/* Whether there is a kernel of that name; says so if not. */
float isakernel(string kernel)
{
    float known = kernel == "box" || kernel == "triangle" || kernel == "gaussian" ||
                  kernel == "catmull-rom" || kernel == "lanczos";
    if (known == 0)
        printf("no kernel is called %s: box, triangle, gaussian, catmull-rom, lanczos\n", kernel);
    return known;
}
