/** SHA-256 (FIPS 180-4), which identifies the exact text of a table. */
#ifndef TTC_SHA256_H
#define TTC_SHA256_H

#include <stddef.h>

/* Write the digest of `length` bytes as 64 lower-case hexadecimal digits and a NUL. */
void ttc_sha256(char digest[65], const void *data, size_t length);

#endif
