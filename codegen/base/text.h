/** A growing piece of text. Once memory runs out it stays failed, and every later call does nothing. */
#ifndef TTC_TEXT_H
#define TTC_TEXT_H

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    char *bytes; /* NUL-terminated once anything was added; NULL before */
    size_t length, capacity;
    bool failed;
} ttc_text;

void ttc_text_clear(ttc_text *text); /* frees; the text is empty and usable afterwards */
void ttc_text_add(ttc_text *text, const char *bytes);
void ttc_text_add_bytes(ttc_text *text, const char *bytes, size_t length);

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void ttc_text_format(ttc_text *text, const char *format, ...);

/* The bytes as a string; "" when nothing was added. Valid until the next change. */
const char *ttc_text_string(const ttc_text *text);

/* `bytes` as the inside of a C string literal; nothing for NULL. */
void ttc_text_add_escaped(ttc_text *text, const char *bytes);

/* `bytes` as the inside of a C comment: the end mark is broken up, line ends become spaces. */
void ttc_text_add_comment(ttc_text *text, const char *bytes);

#endif
