/* The same through the command line: rows of section as they are printed. */
#include "stability/random_tops/trial.h"

#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "dynamics/section.h"

enum { RETURNS = 3 };

/* The fields of a row; what is empty is NaN. Returns their number. */
static int split(double *values, char **words, int room, char *line)
{
    int count = 0;
    line[strcspn(line, "\n")] = '\0';
    for (char *word; count < room && (word = strsep(&line, ",")) != NULL; count++) {
        words[count] = word;
        values[count] = *word != '\0' ? strtod(word, NULL) : NAN;
    }
    return count;
}

static bool check(trial *t, const family *f, const jlt_method *method, const char *how, int number, const char *fate,
                  const double row[ROW_SIZE])
{
    const bool plus = strcmp(fate, "pole+") == 0, minus = strcmp(fate, "pole-") == 0, alive = strcmp(fate, "alive") == 0;

    if (strcmp(fate, "equilibrium") == 0) return false; /* section.c asks */
    if ((alive && number <= f->certain)
        || (f->ends && number == f->truth.count + 1 && f->truth.end == (plus ? ORACLE_POLE_PLUS : ORACLE_POLE_MINUS)
            && (plus || minus)))
        return family_check(f, t, how, number, row);
    const bool spent = strcmp(fate, "budget") == 0, creeps = spent && number > f->certain && f->truth.count > f->certain;
    if (creeps || ((alive || plus || minus) && number > f->certain && !f->ends)) sum.unsure++;
    else if (strcmp(fate, "left_domain") == 0 && family_may_lose_v_tau(f, t, number)) sum.left++;
    else if (spent) section_with_more_steps(t, f, method, how, RETURNS);
    else trial_complain(t, "%s, row %d: %s, and the oracle has %d rows, then %d", how, number, fate, f->truth.count, f->truth.end);
    return false;
}

static void read_rows(trial *t, const family *f, FILE *table, const jlt_method *method, const char *how)
{
    double v[16], row[ROW_SIZE];
    char line[1024], *words[16];

    while (fgets(line, sizeof line, table) != NULL) {
        if ((line[0] < '0' || line[0] > '9') || split(v, words, 16, line) != 9 || v[0] != 0 || v[1] == 0) continue;
        const double at[ROW_SIZE] = { v[4], v[5], NAN, v[6], v[7], NAN, v[2] };
        memcpy(row, at, sizeof row);
        if (!check(t, f, method, how, (int)v[1], words[8], row)) break;
    }
    while (fgets(line, sizeof line, table) != NULL) continue;
}

void case_command(trial *t)
{
    const jlt_top_values *v = &t->top;
    const jlt_method *method = jlt_method_at(jlt_random_below(&t->random, 6));
    const bool batch = jlt_random_below(&t->random, 3) == 0; /* two orbits, the same, go in lanes */
    char folder[PATH_MAX] = "", command[PATH_MAX + 1024], other[128];
    jlt_chart_top chart;
    double x[5];
    static family f;

    jlt_chart_top_init(&chart, v->m, v->R, v->g, v->I1, v->I3, v->a3, v->E, v->G);
    if (chart.base.lift(&chart.base, x, NULL, t->q) != JLT_OK || readlink("/proc/self/exe", folder, sizeof folder - 1) < 0) return;
    const oracle_question q = { .top = trial_top(t),
                                .gamma3 = x[0],
                                .v_nu = x[1],
                                .level = true,
                                .v_tau = x[3],
                                .G = v->G,
                                .time_direction = 1,
                                .crossings = 1,
                                .count = RETURNS,
                                .tolerance = t->tolerance,
                                .speed = t->speed };
    family_follow(&f, t, &q, ORACLE_LEVEL_NOISE);
    if (!f.sound) return;
    snprintf(other, sizeof other, "--start eta=%.17g,gamma3=%.17g", t->q[0], t->q[1]);
    snprintf(command, sizeof command,
             "%s/jellett section --set m=%.17g,R=%.17g,g=%.17g,I1=%.17g,I3=%.17g,a3=%.17g --level E=%.17g,G=%.17g "
             "--start eta=%.17g,gamma3=%.17g --tol %.17g --returns %d %s%s 2>/dev/null",
             dirname(folder), v->m, v->R, v->g, v->I1, v->I3, v->a3, v->E, v->G, t->q[0], t->q[1], t->tolerance, RETURNS,
             batch ? other : "--method ", batch ? "" : method->name);
    FILE *table = popen(command, "r");
    if (table == NULL) return;
    char how[64];
    snprintf(how, sizeof how, "jellett section %s%s", batch ? "in lanes" : "--method ", batch ? "" : method->name);
    read_rows(t, &f, table, batch ? jlt_method_find("gauss") : method, how);
    const int status = pclose(table);
    if (status != 0) trial_complain(t, "ends with %d: %s", status, command);
}
