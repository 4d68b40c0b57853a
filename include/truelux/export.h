// SPDX-License-Identifier: GPL-3.0-or-later
// Which symbols a shared library shows.

#ifndef TRUELUX_EXPORT_H_
#define TRUELUX_EXPORT_H_

/// Marks what the public headers declare and the library defines. The library
/// is compiled with hidden symbols, so that a shared one shows these and
/// nothing of its inside. No user of the library needs the macro.
#if defined(__GNUC__) && !defined(_WIN32)
#define TRUELUX_EXPORT __attribute__((visibility("default")))
#else
#define TRUELUX_EXPORT
#endif

#endif  // TRUELUX_EXPORT_H_
