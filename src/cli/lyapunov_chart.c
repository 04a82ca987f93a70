#include "cli/lyapunov_chart.h"

#include "base/text.h"

#include <math.h>
#include <string.h>

#include "cli/interrupt.h"
#include "cli/lyapunov_losses.h"
#include "cli/orbit_losses.h"
#include "cli/progress.h"
#include "core/memory.h"
#include "dynamics/lyapunov.h"
#include "kernel/batch_isa.h"
#include "report/csv.h"

/* Starts of a chart that are mapped together, for each thread. */
enum { BLOCK = 256 };

jlt_status jlt_lyapunov_chart_skip(jlt_map *map, double *q, size_t skip)
{
    const jlt_chart *chart = jlt_map_flow(map)->chart;
    jlt_image image;
    const jlt_status st = skip > 0 ? jlt_map_point(map, &image, q, skip, 1) : JLT_OK;

    if (skip == 0 || st != JLT_OK) return st;
    if (!jlt_chart_follows(chart, image.x)) return JLT_ERR_NO_CONVERGENCE;
    memcpy(q, image.q, chart->dim * sizeof *q);
    return JLT_OK;
}

jlt_exit jlt_lyapunov_chart_draw(const jlt_lyapunov_chart_options *o, const jlt_system *system, jlt_motion_map *map)
{
    jlt_plot plot;

    if (jlt_plot_open(&plot, &o->motion.common) != JLT_OK) return jlt_command_no_memory();
    jlt_plot_words(&plot, "Finite-time exponent over %zu return%s\n", o->returns, ttc_text_plural(o->returns));
    jlt_motion_caption(&plot, system, NULL);
    jlt_motion_map_palette(map, &plot, jlt_plot_timed(system->instance->descriptor, "exponent [1/s]", "exponent"));
    jlt_motion_map_frame(map, &plot);
    jlt_motion_map_plot(map, &plot);
    if (o->others > 0) jlt_motion_map_blank(map, &plot, "without an exponent");
    else jlt_motion_map_blank(map, &plot, "ended before %zu return%s", o->returns, ttc_text_plural(o->returns));
    fputc('\n', plot.stream);
    return jlt_plot_draw(&plot);
}

/* Map the starts q, shape (count, dim): skip returns, then apply the maps for `returns` more. Out: exponents, images, saddles. */
static jlt_status measure(double *exponents, const jlt_map_images *images, jlt_saddle_watch *saddles,
                          const jlt_lyapunov_chart_options *o, jlt_map *map, jlt_map_batch *maps, const double *q, size_t count)
{
    const unsigned d = jlt_map_flow(map)->chart->dim;
    jlt_status st = JLT_OK;

    memcpy(images->q, q, count * d * sizeof *q);
    for (size_t i = 0; i < count; i++)
        if ((st = jlt_lyapunov_chart_skip(map, images->q + i * d, o->skip)) != JLT_OK)
            for (unsigned k = 0; k < d; k++) images->q[i * d + k] = NAN; /* the orbit has ended already */
    if (st == JLT_ERR_NOMEM) return st;
    return jlt_lyapunov_finite_each(maps, exponents, images, saddles, images->q, count, o->returns);
}

jlt_exit jlt_lyapunov_chart_write(jlt_motion_map *picture, jlt_map *map, jlt_map_batch *maps, jlt_lyapunov_chart_options *o,
                                  const jlt_grid_axis *axes)
{
    const jlt_stream *table = &o->motion.common.table;
    const jlt_system *system = picture->system;
    const jlt_chart *chart = system->flow.chart;
    const unsigned d = chart->dim;
    const size_t all = jlt_motion_grid_size(axes, system), block = BLOCK * o->threads;
    JLT_FREED double *q = malloc(block * (d + 1) * sizeof *q);
    JLT_FREED int *lost = malloc(block * sizeof *lost);
    JLT_FREED jlt_saddle_watch *saddles = malloc(block * sizeof *saddles);
    jlt_orbit_losses losses = { .first = NAN };
    jlt_map_images images = { 0 };
    jlt_csv_names names;
    jlt_progress progress;
    size_t unresolved = 0, strayed = 0, beside = 0;
    jlt_status st = q == NULL || lost == NULL || saddles == NULL ? JLT_ERR_NOMEM : jlt_map_batch_images(&images, d, block);

    if (o->returns == 0) o->returns = 10;
    FILE *line = jlt_csv_names_begin(&names, table->file);
    for (unsigned k = 0; k < d; k++) fprintf(line, "%s,", chart->names[k]);
    fputs("exponent,t", line);
    jlt_csv_names_end(&names);
    jlt_progress_start(&progress, "starts");
    for (size_t first = 0; st == JLT_OK && first < all; first += block) {
        const size_t count = all - first < block ? all - first : block;
        for (size_t i = 0; i < count; i++) jlt_motion_grid_point(q + i * d, axes, system, first + i);
        double *exponents = q + block * d;
        st = measure(exponents, &images, saddles, o, map, maps, q, count);
        if (st == JLT_OK)
            st = jlt_lyapunov_losses(lost, &picture->system, 1, q, NULL, count, o->skip + o->returns, o->motion.in_lanes,
                                     o->threads);
        if (jlt_motion_interrupted(&o->motion)) break;
        for (size_t i = 0; st == JLT_OK && i < count; i++) {
            const bool has_returned = images.status[i] == JLT_OK;
            unresolved += has_returned && isnan(exponents[i]);
            beside += saddles[i].has_left;
            strayed += images.status[i] == JLT_ERR_NO_CONVERGENCE && chart->solved_count > 0;
            losses.orbits += lost[i] != JLT_LYAPUNOV_NO_ORBIT;
            losses.unknown += lost[i] == JLT_LYAPUNOV_UNKNOWN;
            if (lost[i] >= 0) losses.all++, losses.lost[lost[i]]++;
            jlt_csv_values(table->file, q + i * d, d);
            fputc(',', table->file);
            jlt_csv_row(table->file, (const double[]){ exponents[i], has_returned ? images.T[i] : NAN }, 2);
            jlt_motion_map_add(picture, q + i * d, exponents[i]);
        }
        jlt_progress_show(&progress, first + count, all);
    }
    jlt_progress_end(&progress);
    jlt_map_batch_images_clear(&images);
    o->others = unresolved + strayed;
    if (unresolved > 0)
        fprintf(stderr, "jellett: returns of %zu starts contract by more than the tolerance resolves: they have no exponent\n",
                unresolved);
    if (strayed > 0)
        fprintf(stderr, "jellett: of %zu starts a return left the branch of --solve, or was not found: they have no exponent\n",
                strayed);
    if (beside > 0)
        fprintf(stderr, "jellett: orbits of %zu starts pass nearer to a saddle than errors tell separatrices apart: what follows "
                "is one of the motions beside it\n", beside);
    jlt_orbit_losses_tell(&losses, system->flow.observed, "");
    if (jlt_motion_interrupted(&o->motion)) fprintf(stderr, "jellett: interrupted; whole rows are saved in %s\n", table->path);
    return st == JLT_OK ? JLT_EXIT_DONE : jlt_motion_fail(st, system, "chart");
}

jlt_status jlt_lyapunov_chart_maps(jlt_map_batch **out, jlt_lyapunov_chart_options *o, const jlt_system *system, bool has_method)
{
    const jlt_kernel_batch *kernels = has_method ? NULL : jlt_batch_isa_best(system->instance->descriptor, 0);
    jlt_status st;

    if (o->threads == 0) o->threads = jlt_common_processors();
    jlt_interrupt_spare(o->threads);
    st = jlt_map_batch_create(out, &system->flow, kernels, NULL, (unsigned)o->threads);
    if (st == JLT_OK) o->motion.in_lanes = jlt_map_batch_in_lanes(*out); /* for the header */
    return st;
}
