/* SPDX-License-Identifier: Apache-2.0 */
#ident "abc"
#line 10 "foo.sl"
#foo bar
#assert machine(x)
#sccs "x"
#pragma annotation "grouping"                                                                      \
                   "a/b;"
#pragma nolint
surface a()
{
    Ci = __LINE__;
    printf("%s", __FILE__);
    Oi = Os;
}
