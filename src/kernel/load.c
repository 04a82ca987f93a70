#include "kernel/load.h"

#include "registry.h"

#include <dlfcn.h>
#include <string.h>

jlt_status jlt_load(const jlt_descriptor **model, const char *path)
{
    const jlt_descriptor *const *registry;
    const unsigned *count, *size;

    if (path == NULL || strchr(path, '/') == NULL) return JLT_ERR_ARG; /* dlopen would look elsewhere */
    void *object = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (object == NULL) return JLT_ERR_IO;
    registry = dlsym(object, "jlt_registry");
    count = dlsym(object, "jlt_registry_count");
    size = dlsym(object, "jlt_registry_entry_size");
    if (registry == NULL || count == NULL || size == NULL || *size != jlt_registry_entry_size || *count == 0) {
        dlclose(object);
        return JLT_ERR_UNSUPPORTED;
    }
    *model = registry[0];
    return JLT_OK;
}
