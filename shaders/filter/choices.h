/* SPDX-License-Identifier: Apache-2.0
   Parameters that are words. */

/* Says so where one is none of the words that are known ("a|b|c"), and what is taken then. */
void checkchoice(string parameter, given, known, taken)
{
    if (match(concat("^(", known, ")$"), given) == 0)
        printf("%s \"%s\" is not known; known are %s: \"%s\" is taken\n", parameter, given, known,
               taken);
}
