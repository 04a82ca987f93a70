#include "report/picture.h"

#include "report/file.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const struct {
    const char *extension, *terminal;
} formats[] = {
    { ".svg", "svg size 900,650 dynamic background 'white' font 'Helvetica,14'" },
    { ".png", "pngcairo size 1350,975 font 'Helvetica,16'" },
    { ".pdf", "pdfcairo size 18cm,13cm font 'Helvetica,12'" },
};

static const char *terminal_of(const char *path)
{
    const char *dot = strrchr(path, '.');

    for (size_t i = 0; dot != NULL && i < sizeof formats / sizeof *formats; i++)
        if (strcmp(dot, formats[i].extension) == 0) return formats[i].terminal;
    return NULL;
}

bool jlt_picture_known(const char *path)
{
    return terminal_of(path) != NULL;
}

/* Everything that `descriptor` gives until its end, for the caller to free; NULL when memory is out. */
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

static void run_gnuplot(int script, int picture)
{
    dup2(script, STDIN_FILENO);
    dup2(picture, STDOUT_FILENO);
    close(script);
    close(picture);
    execlp("gnuplot", "gnuplot", "-d", "-", (char *)NULL);
    _exit(127);
}

/* gnuplot reads the script from an unlinked temporary file, so that no pipe can block, and writes the picture to a pipe. */
static jlt_status draw(char **data, size_t *size, const char *text, size_t length)
{
    FILE *script = tmpfile();
    int channel[2] = { -1, -1 }, status = 0;
    jlt_status st = JLT_ERR_IO;
    pid_t child;

    *data = NULL;
    if (script == NULL) goto done;
    if (fwrite(text, 1, length, script) != length || fflush(script) != 0 || fseek(script, 0, SEEK_SET) != 0) goto done;
    if (pipe(channel) != 0) goto done;
    child = fork();
    if (child < 0) goto done;
    if (child == 0) {
        close(channel[0]);
        run_gnuplot(fileno(script), channel[1]);
    }
    close(channel[1]);
    channel[1] = -1;
    *data = read_all(channel[0], size);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (*data == NULL) st = JLT_ERR_NOMEM;
    else if (WIFEXITED(status) && WEXITSTATUS(status) == 127) st = JLT_ERR_UNSUPPORTED;
    else if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && *size > 0) st = JLT_OK;
done:
    if (channel[0] >= 0) close(channel[0]);
    if (channel[1] >= 0) close(channel[1]);
    if (script != NULL) fclose(script);
    return st;
}

jlt_status jlt_picture_draw(const char *path, const char *script, const char *keep, const char **refused)
{
    const char *terminal = terminal_of(path);
    char *whole = NULL, *data = NULL;
    size_t length = 0, size = 0;
    jlt_status st = JLT_ERR_NOMEM;
    FILE *stream;

    *refused = NULL;
    if (terminal == NULL) return JLT_ERR_ARG;
    stream = open_memstream(&whole, &length);
    if (stream == NULL) return JLT_ERR_NOMEM;
    fprintf(stream, "set terminal %s\n%s", terminal, script);
    if (fclose(stream) != 0) goto done;
    *refused = keep;
    if (keep != NULL) JLT_TRY(jlt_file_write(keep, whole, length));
    *refused = NULL;
    JLT_TRY(draw(&data, &size, whole, length));
    *refused = path;
    JLT_TRY(jlt_file_write(path, data, size));
done:
    {
        const int reason = errno;
        free(data);
        free(whole);
        errno = reason;
    }
    return st;
}
