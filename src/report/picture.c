#include "report/picture.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
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

/* Where standard input or output were closed, an end may lie in their place: move both away first. */
static void run_gnuplot(int script, int picture)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL); /* nobody waits for the picture then */
    script = fcntl(script, F_DUPFD, STDERR_FILENO + 1);
    picture = fcntl(picture, F_DUPFD, STDERR_FILENO + 1);
    if (dup2(script, STDIN_FILENO) == STDIN_FILENO && dup2(picture, STDOUT_FILENO) == STDOUT_FILENO) {
        close(script);
        close(picture);
        execlp("gnuplot", "gnuplot", "-d", "-", (char *)NULL);
    }
    _exit(127);
}

jlt_status jlt_picture_script(char **whole, size_t *length, const char *path, const char *script)
{
    const char *terminal = terminal_of(path);
    FILE *stream;

    *whole = NULL;
    if (terminal == NULL) return JLT_ERR_ARG;
    stream = open_memstream(whole, length);
    if (stream == NULL) return JLT_ERR_NOMEM;
    fprintf(stream, "set terminal %s\n%s", terminal, script);
    const bool failed = ferror(stream) != 0;
    if (fclose(stream) == 0 && !failed) return JLT_OK;
    free(*whole);
    *whole = NULL;
    return JLT_ERR_NOMEM;
}

/* gnuplot reads the script from an unlinked temporary file, so that no pipe can block, and writes the picture to a pipe, which is
 * closed before gnuplot is waited for: it ends also where nobody reads on. */
jlt_status jlt_picture_draw(char **picture, size_t *size, const char *whole, size_t length)
{
    FILE *script = tmpfile();
    int channel[2] = { -1, -1 }, status = 0;
    jlt_status st = JLT_ERR_IO;
    pid_t child;

    *picture = NULL;
    if (script == NULL) goto done;
    if (fwrite(whole, 1, length, script) != length || fflush(script) != 0 || fseek(script, 0, SEEK_SET) != 0) goto done;
    if (pipe(channel) != 0) goto done;
    child = fork();
    if (child < 0) goto done;
    if (child == 0) {
        close(channel[0]);
        run_gnuplot(fileno(script), channel[1]);
    }
    close(channel[1]);
    channel[1] = -1;
    *picture = read_all(channel[0], size);
    close(channel[0]);
    channel[0] = -1;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    if (*picture == NULL) st = JLT_ERR_NOMEM;
    else if (WIFEXITED(status) && WEXITSTATUS(status) == 127) st = JLT_ERR_UNSUPPORTED;
    else if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && *size > 0) st = JLT_OK;
done:
    if (channel[0] >= 0) close(channel[0]);
    if (channel[1] >= 0) close(channel[1]);
    if (script != NULL) fclose(script);
    if (st == JLT_OK) return st;
    free(*picture);
    *picture = NULL;
    return st;
}
