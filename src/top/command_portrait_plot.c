/* Plots the flow on both halves of M^2 for `jellett portrait`. */
#include "top/command_portrait.h"

#include <math.h>

/* Plot the half of M^2 where side * v_slip > 0. Columns of $ORBITS: psi, gamma3, v_slip; a blank line ends a line. */
static void draw_half(jlt_plot *plot, const jlt_portrait_request *r, int side)
{
    static const struct {
        unsigned colour, mark;
        const char *name;
    } kinds[] = { { 1, 3, "repelling" }, { 0, 7, "trace zero" }, { 4, 0, "attracting" } };

    fprintf(plot->stream, "set title 'half v_{slip} %c 0'\nplot $ORBITS using 1:(%d*$3>0?$2:NaN) ", side > 0 ? '>' : '<', side);
    jlt_look_pen(plot->stream, plot->look, (jlt_pen){ "lines", .colour = 7, .size = 0.1 });
    fputs(" notitle", plot->stream);
    for (unsigned kind = 0; kind < 3; kind++) {
        bool is_named = false;
        for (unsigned k = 0; k < r->fixed_count; k++) {
            if (r->fixed[k].kind != kind || !(side * r->fixed[k].v_slip > 0)) continue;
            fprintf(plot->stream, ", '+' using (%.17g):(%.17g) every ::0::0 ", r->fixed[k].psi, r->fixed[k].x[JLT_TOP_GAMMA3]);
            jlt_look_pen(plot->stream, plot->look,
                         (jlt_pen){ "points", .colour = kinds[kind].colour, .mark = kinds[kind].mark, .size = 1 });
            if (is_named) fputs(" notitle", plot->stream);
            else fprintf(plot->stream, " title '%s'", kinds[kind].name);
            is_named = true;
        }
    }
    fputs("\n", plot->stream);
}

jlt_exit jlt_portrait_draw(const jlt_portrait_request *request)
{
    const jlt_portrait_request *r = request;
    const double pi = acos(-1);
    jlt_plot plot;

    if (jlt_plot_open(&plot, &r->session.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_panels(&plot, 2, false);
    jlt_plot_block(&plot, "ORBITS", r->session.common.drawn);
    jlt_plot_words(&plot, "Flow on M²\n");
    jlt_session_caption(&plot, &r->session);
    jlt_plot_value(&plot, "E", r->levels.E);
    jlt_plot_value(&plot, "G", r->levels.G);
    jlt_plot_value(&plot, "F0", r->levels.F0);
    jlt_plot_words(&plot, "; of %zu orbits %zu are attracted, %zu end at pole +1, %zu at pole −1", r->orbits,
                   r->fates[JLT_PORTRAIT_ATTRACTED], r->fates[JLT_PORTRAIT_POLE_PLUS], r->fates[JLT_PORTRAIT_POLE_MINUS]);
    fputs(JLT_LOOK_GRID, plot.stream);
    jlt_plot_axis(&plot, 'x', "ψ [rad]", (jlt_extent){ -pi, pi }, 2 * pi);
    jlt_plot_axis(&plot, 'y', "γ_3", (jlt_extent){ -1, 1 }, 0);
    draw_half(&plot, r, 1);
    draw_half(&plot, r, -1);
    return jlt_plot_draw(&plot);
}
