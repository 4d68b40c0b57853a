// SPDX-License-Identifier: GPL-3.0-or-later
// Holds the headers that are precompiled for all tests.
