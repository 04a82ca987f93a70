#include "report/letters.h"

#include <errno.h>
#include <spawn.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>

extern char **environ;

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
        const unsigned char first = (unsigned char)*at;
        unsigned code = first;
        *length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
        char letter[5] = "";
        memcpy(letter, at, *length);
        if (*length == 1 || strstr(text, letter) < at) continue;
        code &= 0x7fU >> *length;
        for (size_t i = 1; i < *length; i++) code = code << 6 | ((unsigned char)at[i] & 0x3f);
        if (is_in_no_font(code)) return at;
    }
    return NULL;
}
