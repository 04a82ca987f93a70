/** A string that grows. Once memory runs out, `failed` stays set and later calls that add do nothing. */
#ifndef TTC_TEXT_H
#define TTC_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/* Attribute of a function whose argument number `at` is a printf format for the arguments from number `first` on. */
#if defined(__GNUC__)
#define TTC_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define TTC_PRINTF(at, first)
#endif

typedef struct {
    char *bytes; /* NUL-terminated once anything was added; NULL before */
    size_t length, capacity;
    bool failed;
} ttc_text;

void ttc_text_clear(ttc_text *text); /* frees; the text is empty and usable afterwards */
void ttc_text_add(ttc_text *text, const char *bytes);
void ttc_text_add_bytes(ttc_text *text, const char *bytes, size_t length);

TTC_PRINTF(2, 3) void ttc_text_format(ttc_text *text, const char *format, ...);

/* The text as a C string; "" when nothing was added. Valid until the next change. */
const char *ttc_text_string(const ttc_text *text);

/* FOLDER/NAMEEXTENSION, for the caller to free; NULL when memory is out. */
char *ttc_text_path(const char *folder, const char *name, const char *extension);

/* Add the string `bytes`, escaped for use within a C string literal; NULL adds nothing. */
void ttc_text_add_escaped(ttc_text *text, const char *bytes);

/* Add the string `bytes` for use within a C comment: comment marks are broken up by a space, line ends become spaces. */
void ttc_text_add_comment(ttc_text *text, const char *bytes);

/* Returns true if one of the names a, of n characters, and b, of m, could be the other one mistyped: their first or last letters
 * are equal, and they differ in case and in one character changed, dropped or added, or in two neighbours swapped, at most. */
bool ttc_text_resembles(const char *a, size_t n, const char *b, size_t m);

/* The ending of a noun after this number: "" for 1, else "s". */
const char *ttc_text_plural(size_t count);

#endif
