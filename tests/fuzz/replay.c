/* Feeds files, and every file of a directory, to the fuzz target: the corpus as a test, without a fuzzer. */
#include <dirent.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { INPUT_LIMIT = 1 << 21 };

static int replay_file(const char *path)
{
    int status = 1;
    uint8_t *data = malloc(INPUT_LIMIT);
    FILE *file = fopen(path, "rb");
    if (file == NULL || data == NULL) {
        fprintf(stderr, "replay: cannot read %s\n", path);
    } else {
        size_t size = fread(data, 1, INPUT_LIMIT, file);
        printf("%s\n", path);
        fflush(stdout); /* the last line names the input that ended the program */
        status = LLVMFuzzerTestOneInput(data, size);
    }
    if (file != NULL) fclose(file);
    free(data);
    return status;
}

static int replay(const char *path, size_t *count)
{
    struct stat info;
    if (stat(path, &info) == 0 && !S_ISDIR(info.st_mode)) {
        (*count)++;
        return replay_file(path);
    }
    DIR *directory = opendir(path);
    if (directory == NULL) {
        fprintf(stderr, "replay: cannot open %s\n", path);
        return 1;
    }
    int status = 0;
    for (struct dirent *entry; (entry = readdir(directory)) != NULL;) {
        char inner[4096];
        if (entry->d_name[0] == '.') continue;
        int length = snprintf(inner, sizeof inner, "%s/%s", path, entry->d_name);
        if (length < 0 || (size_t)length >= sizeof inner) status = 1;
        else status |= replay_file(inner);
        (*count)++;
    }
    closedir(directory);
    return status;
}

int main(int argc, char **argv)
{
    int status = 0;
    size_t count = 0;
    for (int i = 1; i < argc; i++) status |= replay(argv[i], &count);
    printf("%zu inputs\n", count);
    return status != 0 || count == 0;
}
