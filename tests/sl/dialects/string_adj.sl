surface a(string tex = "a" "b" ".tx";) { string s1 = "foo" "bar"; Ci = (s1 == "foobar") + match("a", tex "x"); Oi = Os; printf("a" "b\n"); }
