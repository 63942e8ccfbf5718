/* SPDX-License-Identifier: Apache-2.0
   Says where its defaults took a point of its own space. */
surface placed(matrix own = matrix "shader" (2, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1);
               matrix plain = (1, 0, 0, 0,  0, 3, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1);
               point start = point "shader" (1, 2, 3);)
{
    printf("%.2p, %.2p, %.2p\n", transform(own, start), transform(plain, point(1, 2, 3)),
           transform("shader", start));
    Ci = 1;
}
