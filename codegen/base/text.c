#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void ttc_text_clear(ttc_text *text)
{
    free(text->bytes);
    *text = (ttc_text){ 0 };
}

static bool reserve(ttc_text *text, size_t extra)
{
    if (text->failed) return false;
    size_t needed = text->length + extra + 1;
    if (needed <= text->capacity) return true;
    size_t capacity = text->capacity < 64 ? 64 : text->capacity;
    while (capacity < needed) capacity *= 2;
    char *bytes = realloc(text->bytes, capacity);
    if (bytes == NULL) {
        text->failed = true;
        return false;
    }
    text->bytes = bytes;
    text->capacity = capacity;
    return true;
}

void ttc_text_add_bytes(ttc_text *text, const char *bytes, size_t length)
{
    if (!reserve(text, length)) return;
    if (length > 0) memcpy(text->bytes + text->length, bytes, length);
    text->length += length;
    text->bytes[text->length] = '\0';
}

void ttc_text_add(ttc_text *text, const char *bytes) { ttc_text_add_bytes(text, bytes, strlen(bytes)); }

void ttc_text_format(ttc_text *text, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    int length = vsnprintf(NULL, 0, format, list);
    va_end(list);
    if (length < 0 || !reserve(text, (size_t)length)) {
        text->failed = true;
        return;
    }
    va_start(list, format);
    vsnprintf(text->bytes + text->length, (size_t)length + 1, format, list);
    va_end(list);
    text->length += (size_t)length;
}

const char *ttc_text_string(const ttc_text *text) { return text->bytes == NULL ? "" : text->bytes; }

/* Octal escapes end after three digits, so that a digit which follows is not read as part of them. */
void ttc_text_add_escaped(ttc_text *text, const char *bytes)
{
    for (const unsigned char *c = (const unsigned char *)bytes; c != NULL && *c != '\0'; c++) {
        if (*c == '"' || *c == '\\' || *c == '?') ttc_text_format(text, "\\%c", *c);
        else if (*c == '\n') ttc_text_add(text, "\\n");
        else if (*c < 32 || *c > 126) ttc_text_format(text, "\\%03o", *c);
        else ttc_text_add_bytes(text, (const char *)c, 1);
    }
}

void ttc_text_add_comment(ttc_text *text, const char *bytes)
{
    for (const char *c = bytes; *c != '\0'; c++) {
        if ((c[0] == '*' && c[1] == '/') || (c[0] == '/' && c[1] == '*')) ttc_text_format(text, "%c ", *c);
        else if (*c == '\n' || *c == '\r') ttc_text_add(text, " ");
        else ttc_text_add_bytes(text, c, 1);
    }
}

char *ttc_text_path(const char *folder, const char *name, const char *extension)
{
    ttc_text text = { 0 };
    ttc_text_format(&text, "%s/%s%s", folder, name, extension);
    if (text.failed) ttc_text_clear(&text);
    return text.bytes;
}

static char lower(char c) { return (char)(c | 0x20); }

bool ttc_text_resembles(const char *a, size_t n, const char *b, size_t m)
{
    size_t head = 0, tail = 0;
    while (head < n && head < m && lower(a[head]) == lower(b[head])) head++;
    while (tail < n - head && tail < m - head && lower(a[n - 1 - tail]) == lower(b[m - 1 - tail])) tail++;
    const char *p = a + head, *q = b + head; /* what is between */
    n -= head + tail;
    m -= head + tail;
    const bool swapped = n == 2 && m == 2 && lower(p[0]) == lower(q[1]) && lower(p[1]) == lower(q[0]);
    return head + tail > 0 && ((n <= 1 && m <= 1) || swapped);
}

const char *ttc_text_plural(size_t count)
{
    return count == 1 ? "" : "s";
}
