/* SPDX-License-Identifier: Apache-2.0 */
surface a()
{
    I = normalize(I);
    Ci = specular(normalize(N), -I, .1);
}
