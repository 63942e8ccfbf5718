/* SPDX-License-Identifier: Apache-2.0 */
filter forever()
{
    float turns = 0;
    while (turns >= 0) {
        turns += 1;
        setimage("Ci", 0, 0, turns);
    }
}
