#include "base/source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Open a regular file; others are refused: pipes and devices may block or never end. Returns NULL after reporting an error. */
static FILE *open_regular(const char *path, ttc_diagnostics *diagnostics)
{
    struct stat status;
    const int descriptor = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    FILE *file = NULL;
    if (descriptor < 0 || fstat(descriptor, &status) != 0)
        ttc_report(diagnostics, TTC_IO_ERROR, 0, 0, "cannot open the file: %s", strerror(errno));
    else if (S_ISDIR(status.st_mode))
        ttc_report(diagnostics, TTC_IO_ERROR, 0, 0, "cannot read the file: %s", strerror(EISDIR));
    else if (!S_ISREG(status.st_mode))
        ttc_report(diagnostics, TTC_IO_ERROR, 0, 0, "cannot read the file: it is a pipe or a device (expected a regular file)");
    else if ((file = fdopen(descriptor, "rb")) == NULL)
        ttc_report(diagnostics, TTC_IO_ERROR, 0, 0, "cannot open the file: %s", strerror(errno));
    if (file == NULL && descriptor >= 0) close(descriptor);
    return file;
}

char *ttc_source_read(const char *path, size_t *length, ttc_diagnostics *diagnostics)
{
    char *text = NULL;
    int error = 0;
    FILE *file = open_regular(path, diagnostics);
    if (file == NULL) return NULL;
    text = malloc((size_t)TTC_SOURCE_LIMIT + 2);
    if (text != NULL) {
        errno = 0;
        *length = fread(text, 1, (size_t)TTC_SOURCE_LIMIT + 1, file);
        if (ferror(file)) error = errno == 0 ? EIO : errno;
        text[*length] = '\0';
    } else {
        error = ENOMEM;
    }
    fclose(file);
    if (error != 0) {
        ttc_report(diagnostics, TTC_IO_ERROR, 0, 0, "cannot read the file: %s", strerror(error));
        free(text);
        return NULL;
    }
    return text;
}

/* Bytes of the UTF-8 sequence at `at`, with `left` bytes remaining; 0 if invalid (overlong, a surrogate, or beyond U+10FFFF). */
static size_t sequence_length(const unsigned char *at, size_t left)
{
    unsigned char c = at[0];
    if (c < 0x80) return 1;
    size_t length = c >= 0xC2 && c <= 0xDF ? 2 : c >= 0xE0 && c <= 0xEF ? 3 : c >= 0xF0 && c <= 0xF4 ? 4 : 0;
    if (length == 0 || length > left) return 0;
    for (size_t i = 1; i < length; i++)
        if ((at[i] & 0xC0u) != 0x80u) return 0;
    if ((c == 0xE0 && at[1] < 0xA0) || (c == 0xED && at[1] > 0x9F) || (c == 0xF0 && at[1] < 0x90) ||
        (c == 0xF4 && at[1] > 0x8F))
        return 0;
    return length;
}

static const char *complaint(const unsigned char *at, size_t left, size_t *advance)
{
    *advance = sequence_length(at, left);
    if (*advance == 0) return "a byte that is not UTF-8 (expected UTF-8 text)";
    if (*at == '\0') return "a NUL byte (expected UTF-8 text)";
    if (*at == '\r') return "a carriage return (expected lines that end in a line feed alone)";
    if ((*at < 0x20 && *at != '\t' && *at != '\n') || *at == 0x7f) return "a control character (expected printable text)";
    if (*advance == 3 && at[0] == 0xEF && at[1] == 0xBB && at[2] == 0xBF) return "a byte order mark (expected none)";
    return NULL;
}

bool ttc_source_check(const char *text, size_t length, ttc_diagnostics *diagnostics)
{
    if (length > TTC_SOURCE_LIMIT) {
        ttc_report(diagnostics, TTC_ERROR, 1, 1, "the table is too large (expected at most %d bytes)", TTC_SOURCE_LIMIT);
        return false;
    }
    const unsigned char *start = (const unsigned char *)text, *line_start = start;
    uint32_t line = 1;
    for (size_t i = 0, advance; i < length; i += advance) {
        const char *wrong = complaint(start + i, length - i, &advance);
        if (wrong != NULL) {
            ttc_report(diagnostics, TTC_ERROR, line, (uint32_t)(start + i - line_start) + 1, "%s", wrong);
            return false;
        }
        if (start[i] == '\n') {
            line++;
            line_start = start + i + 1;
        }
    }
    return true;
}
