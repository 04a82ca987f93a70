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
    if (strchr(name, '/') != NULL) return is_executable(name) ? strdup(name) : NULL;
    for (const char *at = getenv("PATH"), *next; at != NULL; at = next) {
        const size_t length = strcspn(at, ":");
        next = at[length] == ':' ? at + length + 1 : NULL;
        ttc_text file = { 0 };
        ttc_text_format(&file, "%.*s/%s", length > 0 ? (int)length : 1, length > 0 ? at : ".", name);
        if (!file.failed && is_executable(file.bytes)) return file.bytes;
        ttc_text_clear(&file);
    }
    return NULL;
}
