#include "core/status.h"

#define JLT_STATUS_TEXT(name, text) text,

const char *jlt_status_text(jlt_status status)
{
    static const char *const texts[] = { JLT_STATUS_LIST(JLT_STATUS_TEXT) };
    if ((unsigned)status >= sizeof texts / sizeof *texts) return "unknown status";
    return texts[status];
}
