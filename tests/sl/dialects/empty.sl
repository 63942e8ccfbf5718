surface a() {}
