/* SPDX-License-Identifier: Apache-2.0
   Blows up by so much, and leaves the normal to others. */
displacement swell(float by = .2;)
{
    P += by * normalize(N);
}
