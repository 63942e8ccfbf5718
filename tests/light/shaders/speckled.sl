/* SPDX-License-Identifier: Apache-2.0 */
/* From where the eye looks to, by chance from 0 to 1. */
light speckled()
{
    solar(vector "shader" (0, 0, 1), 0)
        Cl = random();
}
