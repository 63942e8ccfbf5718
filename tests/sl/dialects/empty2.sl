displacement a(void) { }
