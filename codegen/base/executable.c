#include "base/executable.h"
#include "base/text.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_executable(const char *path)
{
    struct stat found;
    return stat(path, &found) == 0 && S_ISREG(found.st_mode) && access(path, X_OK) == 0;
}

char *ttc_executable_find(const char *name)
{
    const char *path = getenv("PATH");
    if (strchr(name, '/') != NULL) return is_executable(name) ? strdup(name) : NULL;
    for (const char *at = path; at != NULL && *at != '\0';) {
        const size_t length = strcspn(at, ":");
        ttc_text file = { 0 };
        ttc_text_format(&file, "%.*s/%s", length > 0 ? (int)length : 1, length > 0 ? at : ".", name);
        if (!file.failed && is_executable(file.bytes)) return file.bytes;
        ttc_text_clear(&file);
        at += length + (at[length] == ':');
    }
    return NULL;
}
