#include "report/letters.h"

#include <errno.h>
#include <spawn.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

extern char **environ;

/* The length in bytes of the UTF-8 character at the start of the text, and its number; 0: there is no valid one. */
static size_t read_character(unsigned *code, const char *text)
{
    static const unsigned least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    const unsigned first = (unsigned char)text[0];
    const size_t length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;

    *code = length == 1 ? first : first & 0x7fU >> length;
    for (size_t i = 1; i < length; i++) {
        if (((unsigned char)text[i] & 0xc0) != 0x80) return 0;
        *code = *code << 6 | ((unsigned char)text[i] & 0x3f);
    }
    return *code >= least[length] && *code <= 0x10ffff && *code >> 11 != 0x1b ? length : 0; /* 0xd800 on: halves of UTF-16 */
}

bool jlt_letters_fit(const char *text)
{
    unsigned code;

    for (size_t length; *text != '\0'; text += length) {
        length = read_character(&code, text);
        if (length == 0 || (code < 0x20 && code != '\n') || (code >= 0x7f && code < 0xa0) || code == 0xfffe || code == 0xffff)
            return false;
    }
    return true;
}

static bool is_in_no_font(unsigned code)
{
    char pattern[32], *const arguments[] = { "fc-list", "-q", pattern, NULL };
    int status = 0;
    pid_t child;

    snprintf(pattern, sizeof pattern, ":charset=%x", code);
    if (posix_spawnp(&child, arguments[0], NULL, NULL, arguments, environ) != 0) return false;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 1;
}

const char *jlt_letters_missing(const char *text, size_t *length)
{
    for (const char *at = text; *at != '\0'; at += *length) {
        unsigned code;
        char letter[5] = "";
        *length = read_character(&code, at);
        memcpy(letter, at, *length);
        if (*length == 1 || strstr(text, letter) < at) continue;
        if (is_in_no_font(code)) return at;
    }
    return NULL;
}
