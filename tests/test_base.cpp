// Holds the headers that are precompiled for all tests.
