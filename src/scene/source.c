#include "scene/source.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ext/number.h"

static jlt_status read_file(char **text, size_t *size, const jlt_value_reader *r)
{
    FILE *file = fopen(r->file, "r");
    jlt_status st = JLT_OK;

    *text = malloc(JLT_SOURCE_MAX + 2);
    *size = 0;
    if (file == NULL) {
        (void)jlt_value_complain(r, 0, "%s", strerror(errno));
        return JLT_ERR_IO;
    }
    errno = 0;
    if (*text == NULL) st = JLT_ERR_NOMEM;
    else *size = fread(*text, 1, JLT_SOURCE_MAX + 1, file);
    if (st == JLT_OK && ferror(file)) {
        (void)jlt_value_complain(r, 0, "%s", strerror(errno));
        st = JLT_ERR_IO;
    }
    fclose(file);
    if (st != JLT_OK) return st;
    if (*size > JLT_SOURCE_MAX) return jlt_value_complain(r, 0, "a scene has at most %d bytes", (int)JLT_SOURCE_MAX);
    (*text)[*size] = '\0';
    return JLT_OK;
}

static int lines_in(const char *from, const char *to)
{
    int lines = 0;

    for (; from < to; from++) lines += *from == '\n';
    return lines;
}

/* The end of the comment or quoted string that begins here; NULL if neither begins here. */
static const char *skip_text(const char *at)
{
    if (*at == '#' || (at[0] == '/' && at[1] == '/')) return at + strcspn(at, "\n");
    if (at[0] == '/' && at[1] == '*') {
        const char *end = strstr(at + 2, "*/");
        return end != NULL ? end + 2 : at + strlen(at);
    }
    if (*at != '"') return NULL;
    for (at++; *at != '\0' && *at != '"'; at++)
        if (*at == '\\' && at[1] != '\0') at++;
    return *at == '"' ? at + 1 : at;
}

/* The end of the number, without a sign, that begins here. Out: *too_large, it is an integer that overflows; *outside, it is no
 * integer, and no double is near it, or a point without digits; *other_base, it is hexadecimal, binary or octal, as whole numbers
 * with zeros in front are for some versions of libconfig, and not for others. */
static const char *skip_number(const char *at, bool *too_large, bool *outside, bool *other_base)
{
    const char *end = at;
    bool whole = true;
    double ignored;
    char *last;

    while (isalnum((unsigned char)*end) || *end == '.') {
        const bool exponent = *end == 'e' || *end == 'E';
        whole = whole && !exponent && *end != '.';
        end += exponent && (end[1] == '-' || end[1] == '+') ? 2 : 1;
    }
    errno = 0;
    const unsigned long long value = strtoull(at, &last, 10);
    const unsigned long long most = *last == 'L' ? LLONG_MAX : INT_MAX;
    *other_base = at[0] == '0' && at[1] != '\0' && (strchr("xXbBoOqQ", at[1]) != NULL || (whole && isdigit((unsigned char)at[1])));
    *too_large = whole && (errno == ERANGE || value > most);
    *outside = !whole && jlt_number_parse(&ignored, at, (size_t)(end - at)) != JLT_OK;
    return end;
}

/* Whether a number begins here, without a sign. A point does so, even without digits, but not before a name. */
static bool begins_number(const char *at)
{
    if (*at != '.') return isdigit((unsigned char)*at);
    return !isalpha((unsigned char)at[1]) || (tolower((unsigned char)at[1]) == 'e' && !isalpha((unsigned char)at[2]));
}

static jlt_status check(const char *text, const jlt_value_reader *r)
{
    const char *at = text, *next;
    int line = 1;

    while (*at != '\0') {
        bool too_large = false, outside = false, other_base = false;
        next = skip_text(at);
        if (next == NULL && strncmp(at, "@include", 8) == 0)
            return jlt_value_complain(r, line, "@include is not for scenes: a scene is one file");
        if (next == NULL && begins_number(at)) next = skip_number(at, &too_large, &outside, &other_base);
        if (other_base)
            return jlt_value_complain(r, line, "%.*s: numbers are decimal, and whole ones have no zeros in front",
                                      next - at > 64 ? 64 : (int)(next - at), at);
        if (outside)
            return jlt_value_complain(r, line, "%.*s is no number in the range of doubles, 2.3e-308 to 1.8e308",
                                      next - at > 64 ? 64 : (int)(next - at), at);
        if (too_large)
            return jlt_value_complain(r, line,
                                      "the whole number %.*s is too large (up to 9223372036854775807 it takes an L behind it; "
                                      "beyond, write a decimal point)",
                                      next - at > 64 ? 64 : (int)(next - at), at);
        if (next == NULL && (isalpha((unsigned char)*at) || *at == '_'))
            for (next = at; isalnum((unsigned char)*next) || *next == '_' || *next == '-';) next++;
        if (next == NULL) next = at + 1;
        line += lines_in(at, next);
        at = next;
    }
    return JLT_OK;
}

jlt_status jlt_source_read(char **text, const jlt_value_reader *r)
{
    size_t size;
    jlt_status st = read_file(text, &size, r);

    if (st == JLT_OK && strlen(*text) != size)
        st = jlt_value_complain(r, 1 + lines_in(*text, *text + strlen(*text)), "a byte that is zero: this is no text");
    if (st == JLT_OK && strncmp(*text, "\xef\xbb\xbf", 3) == 0) st = jlt_value_complain(r, 1, "a byte order mark (expected none)");
    if (st == JLT_OK) st = check(*text, r);
    if (st == JLT_OK) return JLT_OK;
    free(*text);
    *text = NULL;
    return st;
}
