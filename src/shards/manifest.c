#include "shards/manifest.h"

#include <string.h>

#include "core/memory.h"
#include "report/json.h"

static void show(FILE *stream, const json_t *value)
{
    JLT_FREED char *text = value != NULL ? json_dumps(value, JSON_ENCODE_ANY | JSON_COMPACT) : NULL;

    fputs(text != NULL ? text : "nothing", stream);
}

static bool compare(FILE *stream, const char *group, json_t *there, json_t *here)
{
    const char *key;
    json_t *value;
    bool differ = false;

    json_object_foreach(there, key, value) {
        json_t *other = json_object_get(here, key);
        if (json_equal(value, other)) continue;
        differ = true;
        if (json_is_object(value) && json_is_object(other)) {
            compare(stream, key, value, other);
            continue;
        }
        fprintf(stream, "  %s%s%s: there ", group, group[0] != '\0' ? "." : "", key);
        show(stream, value);
        fputs(", here ", stream);
        show(stream, other);
        fputc('\n', stream);
    }
    json_object_foreach(here, key, value) {
        if (json_object_get(there, key) != NULL) continue;
        differ = true;
        fprintf(stream, "  %s%s%s: there nothing, here ", group, group[0] != '\0' ? "." : "", key);
        show(stream, value);
        fputc('\n', stream);
    }
    return differ;
}

bool jlt_manifest_difference(FILE *stream, const char *there, const char *here)
{
    json_auto_t *a = json_loads(there, 0, NULL), *b = json_loads(here, 0, NULL);

    return compare(stream, "", a, b);
}
