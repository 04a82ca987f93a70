#include "top/command_portrait.h"

#include <stdlib.h>

/* Columns of $ORBITS: psi, gamma3, v_slip; a blank line where a line breaks off. The half of M^2 where side * v_slip > 0. */
static void draw_half(FILE *stream, const jlt_portrait_request *r, int side)
{
    static const struct {
        const char *style, *name;
    } kinds[] = { { "pt 6 ps 1.6 lw 2 lc rgb '#b2182b'", "repelling" },
                  { "pt 2 ps 1.6 lw 2 lc rgb '#404040'", "trace zero" },
                  { "pt 7 ps 1.6 lc rgb '#1a6b30'", "attracting" } };

    fprintf(stream, "set title 'half v_{slip} %c 0'\nplot $ORBITS using 1:(%d*$3 > 0 ? $2 : NaN) with lines lc rgb '#8090b0' notitle",
            side > 0 ? '>' : '<', side);
    for (unsigned k = 0; k < r->fixed_count; k++)
        if (side * r->fixed[k].v_slip > 0)
            fprintf(stream, ", '+' using (%.9g):(%.9g) every ::0::0 with points %s title '%s'", r->fixed[k].psi,
                    r->fixed[k].x[JLT_TOP_GAMMA3], kinds[r->fixed[k].kind].style, kinds[r->fixed[k].kind].name);
    fputs("\n", stream);
}

jlt_exit jlt_portrait_draw(const jlt_portrait_request *request, const char *points)
{
    const jlt_portrait_request *r = request;
    jlt_command_output script;
    FILE *stream;

    if (jlt_command_open(&script) != JLT_OK) return jlt_command_no_memory();
    stream = script.stream;
    fprintf(stream, "set encoding utf8\nset grid\n$ORBITS << END\n%s\n", points);
    fputs("END\nset multiplot layout 1,2 title \"Flow on M^2: ", stream);
    jlt_session_caption(stream, &r->session);
    fprintf(stream, "\\nE=%.6g, G=%.6g, F_0=%.6g; %zu orbits, both ways over %.6g s; forwards %zu are attracted, %zu end at pole +1, "
                    "%zu at pole -1\" noenhanced\n",
            r->levels.E, r->levels.G, r->levels.F0, r->orbits, r->until, r->fates[JLT_PORTRAIT_ATTRACTED],
            r->fates[JLT_PORTRAIT_POLE_PLUS], r->fates[JLT_PORTRAIT_POLE_MINUS]);
    fputs("set xrange [-pi:pi]\nset yrange [-1:1]\nset xlabel \"ψ [rad]\"\nset ylabel \"γ_3\"\n"
          "unset key\n",
          stream);
    if (r->fixed_count > 0) fputs("set key inside bottom left opaque box\n", stream);
    draw_half(stream, r, 1);
    draw_half(stream, r, -1);
    fputs("unset multiplot\n", stream);
    return jlt_common_draw(&r->session.common, &script);
}
