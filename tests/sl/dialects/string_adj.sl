/* SPDX-License-Identifier: Apache-2.0 */
surface a(string tex = "a"
                       "b"
                       ".tx";)
{
    string s1 = "foo"
                "bar";
    Ci = (s1 == "foobar") + match("a", "te"
                                       "x");
    Oi = Os;
    printf("a"
           "b\n");
}
