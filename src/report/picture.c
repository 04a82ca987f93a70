#define _GNU_SOURCE /* memfd_create */
#include "report/picture.h"

#include "report/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

/* All three terminals use sizes on paper: letters in points; gnuplot's unit is 0.5 pt for line widths, 6 pt for points. */
static void svg(FILE *stream, const jlt_look *look)
{
    const double dots = 96 / 2.54; /* to the cm, as CSS has them */
    fprintf(stream, "svg size %.0f,%.0f fixed background 'white' fontscale 1.333 linewidth 0.667 font '%.*s,%.4g'",
            look->width * dots, look->height * dots, (int)look->font_length, look->font, jlt_look_points(look));
}

static void png(FILE *stream, const jlt_look *look)
{
    const double dots = 300 / 2.54;
    fprintf(stream, "pngcairo size %.0f,%.0f fontscale 3.125 linewidth 2.083 pointscale 4.3 font '%.*s,%.4g'", look->width * dots,
            look->height * dots, (int)look->font_length, look->font, jlt_look_points(look));
}

static void pdf(FILE *stream, const jlt_look *look)
{
    fprintf(stream, "pdfcairo size %.6gcm,%.6gcm fontscale 0.75 font '%.*s,%.4g'", look->width, look->height,
            (int)look->font_length, look->font, jlt_look_points(look));
}

static const struct format {
    const char *extension;
    void (*terminal)(FILE *stream, const jlt_look *look);
    bool has_fonts;
} formats[] = { { ".svg", svg, false }, { ".png", png, true }, { ".pdf", pdf, true }, { ".eps", NULL, true },
                { ".ps", NULL, true },  { ".jpg", NULL, true }, { ".jpeg", NULL, true }, { ".gif", NULL, true } };

static const struct format *format_of(const char *path)
{
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (jlt_file_ends(path, formats[i].extension)) return &formats[i];
    return NULL;
}

bool jlt_picture_is_named(const char *path)
{
    return format_of(path) != NULL;
}

bool jlt_picture_known(const char *path)
{
    return jlt_picture_is_named(path) && format_of(path)->terminal != NULL;
}

bool jlt_picture_has_fonts(const char *path)
{
    return format_of(path)->has_fonts;
}

/* Read `descriptor` to its end. Returns the data, for the caller to free; NULL when memory is out. */
static char *read_all(int descriptor, size_t *size)
{
    size_t room = 1 << 16;
    char *data = malloc(room);

    *size = 0;
    while (data != NULL) {
        const ssize_t got = read(descriptor, data + *size, room - *size);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        *size += (size_t)got;
        if (*size == room) {
            char *larger = realloc(data, room *= 2);
            if (larger == NULL) free(data);
            data = larger;
        }
    }
    return data;
}

/* In the child. Its standard descriptors are open, so that script, picture and words are other descriptors. */
static void run_gnuplot(int script, int picture, int words)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* when the parent ends, nobody reads the picture */
    if (dup2(script, STDIN_FILENO) >= 0 && dup2(picture, STDOUT_FILENO) >= 0 && dup2(words, STDERR_FILENO) >= 0)
        execlp("gnuplot", "gnuplot", "-d", "-", (char *)NULL);
    _exit(127);
}

void jlt_picture_terminal(FILE *stream, const char *path, const jlt_look *look)
{
    fputs("set terminal ", stream);
    format_of(path)->terminal(stream, look);
    fputs("\nset encoding utf8\nset minussign\n", stream);
}

/* Why gnuplot failed, from its words: EMPTY, there is nothing to draw; IO for any other reason, and the words are passed on; errno
 * is 0 if there are any. */
static jlt_status failure(FILE *words)
{
    char text[4096];
    size_t length;
    bool empty = false;
    int reason = ECANCELED;

    rewind(words);
    while (fgets(text, sizeof text, words) != NULL)
        empty = empty || strstr(text, "value undefined") != NULL || strstr(text, "range is invalid") != NULL;
    if (empty) return JLT_ERR_EMPTY;
    rewind(words);
    for (; (length = fread(text, 1, sizeof text, words)) > 0; reason = 0)
        if (write(STDERR_FILENO, text, length) < 0) break; /* there is nowhere else to say it */
    errno = reason;
    return JLT_ERR_IO;
}

/* A file in memory, so that a full disk does not matter; NULL: memory is out. */
static FILE *open_file(const char *name)
{
    const int descriptor = memfd_create(name, MFD_CLOEXEC);
    FILE *file = descriptor >= 0 ? fdopen(descriptor, "w+") : NULL;

    if (file == NULL && descriptor >= 0) close(descriptor);
    return file;
}

/* gnuplot reads the script from a file, so that no pipe can block, and writes the picture to a pipe. The pipe is closed before
 * waiting for gnuplot, which then ends even if reading stopped early. */
jlt_status jlt_picture_draw(char **picture, size_t *size, const char *whole, size_t length)
{
    FILE *script = open_file("script"), *words = open_file("words");
    int channel[2] = { -1, -1 }, status = 0;
    jlt_status st = JLT_ERR_IO;
    pid_t child;

    *picture = NULL;
    if (script == NULL || words == NULL) goto done;
    if (fwrite(whole, 1, length, script) != length || fflush(script) != 0 || fseek(script, 0, SEEK_SET) != 0) goto done;
    if (pipe2(channel, O_CLOEXEC) != 0) goto done;
    child = fork();
    if (child < 0) goto done;
    if (child == 0) run_gnuplot(fileno(script), channel[1], fileno(words));
    close(channel[1]);
    channel[1] = -1;
    *picture = read_all(channel[0], size);
    close(channel[0]);
    channel[0] = -1;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (*picture == NULL) st = JLT_ERR_NOMEM;
    else if (WIFEXITED(status) && WEXITSTATUS(status) == 127 && lseek(fileno(words), 0, SEEK_END) == 0) st = JLT_ERR_UNSUPPORTED;
    else if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && *size > 0) st = JLT_OK;
    else st = failure(words);
done:
    if (channel[0] >= 0) close(channel[0]);
    if (channel[1] >= 0) close(channel[1]);
    if (script != NULL) fclose(script);
    if (words != NULL) fclose(words);
    if (st == JLT_OK) return st;
    free(*picture);
    *picture = NULL;
    return st;
}
