/** SHA-256 (FIPS 180-4): the name of a table's exact text. */
#ifndef TTC_SHA256_H
#define TTC_SHA256_H

#include <stddef.h>

/* 64 lower-case hexadecimal digits and a NUL. Cost: linear in length. */
void ttc_sha256(char digest[65], const void *data, size_t length);

#endif
