/* dapple/api.h: marks what the shared library exports. */
#ifndef DAPPLE_API_H
#define DAPPLE_API_H

#define DPL_VERSION "0.1.0"

#if defined(__GNUC__)
#define DPL_API __attribute__((visibility("default")))
#define DPL_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define DPL_API
#define DPL_PRINTF(text, first)
#endif

#endif
