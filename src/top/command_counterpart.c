#include "top/command_counterpart.h"

#include <string.h>

jlt_exit jlt_top_counterpart(jlt_counterpart *out, const jlt_session *session, const char *shared, const char *what)
{
    const jlt_claim *broken;
    const jlt_status st = jlt_counterpart_open(out, &broken, session->descriptor, shared, session->params, NULL);
    const char *model = session->common.model != NULL ? session->common.model : JLT_DEFAULT_MODEL;
    const char *other = jlt_counterpart_other_state(session->descriptor);
    const jlt_way_condition *condition;
    char record[512];

    if (st == JLT_OK) return JLT_EXIT_DONE;
    if (other != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: known of the states of %s alone, and %s differs in the state %s: follow yours "
                                                "by jellett simulate", what, JLT_DEFAULT_MODEL, model, other);
    if (broken != NULL) return jlt_top_unproved(broken, model, what);
    condition = jlt_counterpart_condition(session->descriptor, shared, session->params);
    if (condition != NULL)
        return jlt_command_fail(JLT_EXIT_INPUT, "%s: the reduction of %s serves where %s: see --set", what, model, condition->text);
    for (unsigned i = 0; i < session->descriptor->way_count; i++) {
        const jlt_way *way = &session->descriptor->ways[i];
        if (strcmp(way->model, shared) == 0)
            return jlt_command_fail(JLT_EXIT_INPUT, "%s: known of the table %s that is built in alone, and the reduction %s of %s "
                                                    "leads to another one, %s beside it: put the one that is built in there, or "
                                                    "follow yours by jellett simulate",
                                    what, shared, way->name, model, way->file);
    }
    broken = jlt_counterpart_unproved(session->descriptor, shared);
    if (broken != NULL) return jlt_top_unproved(broken, model, what);
    jlt_counterpart_record(record, sizeof record, shared);
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: known of spherical tops, and %s does not say that it is one: write '%s', "
                                            "which is to be proved, of the table as it is built in",
                            what, model, record);
}

jlt_exit jlt_top_unproved(const jlt_claim *broken, const char *of, const char *what)
{
    return jlt_command_fail(JLT_EXIT_INPUT, "%s: the claim '%s %s' of %s, on which this would rest, is not proved: %s", what,
                            broken->kind, broken->name, of, broken->reason);
}
