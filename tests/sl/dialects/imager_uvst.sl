/* SPDX-License-Identifier: Apache-2.0 */
imager a()
{
    Ci = mix(color(s, t, 0), color(u, v, 1), alpha);
}
