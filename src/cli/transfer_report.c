#include "cli/transfer_report.h"

#include <math.h>
#include <string.h>

#include "core/digits.h"
#include "report/csv.h"
#include "report/json.h"

/* The column name of a kind of loss. */
static const char *loss_name(char name[JLT_FATE_TEXT_MAX], const jlt_transfer_report *r, unsigned loss)
{
    if (loss == 0) return "outside";
    if (loss == JLT_TRANSFER_SECTION_BRANCH) return "other_branch";
    jlt_section_fate_text(name, r->system->observed, (jlt_fate)loss, JLT_OBSERVED_ANY);
    return name;
}

/* Whether any box of the first operator has this loss. */
static bool occurs(const jlt_transfer_report *r, unsigned loss)
{
    const jlt_transfer *t = r->cases[0].transfer;

    for (size_t i = 0; i < t->count; i++)
        if (t->lost[i * t->losses + loss] > 0) return true;
    return false;
}

static void write_names(FILE *file, const jlt_transfer_report *r, const bool *has_loss)
{
    const jlt_transfer_finding *f = &r->cases[0].finding;
    const jlt_chart *chart = r->system->flow.chart;
    char name[JLT_FATE_TEXT_MAX];
    jlt_csv_names names;
    FILE *line = jlt_csv_names_begin(&names, file);

    for (unsigned k = 0; k < chart->dim; k++) fprintf(line, "%s,", chart->names[k]);
    fputs("share", line);
    if (f->spectrum.leading != NULL) fputs(",mass,density", line);
    if (f->spectrum.second != NULL) fputs(",second", line);
    if (r->known != NULL) fputs(",known_density", line);
    for (unsigned k = 0; k < JLT_TRANSFER_SECTION_LOSSES; k++)
        if (has_loss[k]) fprintf(line, ",%s", loss_name(name, r, k));
    fputs(",time", line);
    jlt_csv_names_end(&names);
}

void jlt_transfer_report_rows(FILE *file, const jlt_transfer_report *r)
{
    const jlt_transfer *t = r->cases[0].transfer;
    const jlt_transfer_spectrum *s = &r->cases[0].finding.spectrum;
    bool has_loss[JLT_TRANSFER_SECTION_LOSSES];
    double row[JLT_BOXES_DIM_MAX + 6 + JLT_TRANSFER_SECTION_LOSSES];
    size_t all;

    for (unsigned k = 0; k < JLT_TRANSFER_SECTION_LOSSES; k++) has_loss[k] = occurs(r, k);
    write_names(file, r, has_loss);
    if (jlt_boxes_count(&all, &t->boxes) != JLT_OK) return;
    for (size_t box = 0; box < all; box++) {
        const size_t i = t->kept[box];
        unsigned n = t->boxes.dim;
        if (t->kept[box] == JLT_TRANSFER_NONE) continue;
        jlt_boxes_centre(&t->boxes, row, box);
        row[n++] = t->share[i];
        if (s->leading != NULL) row[n++] = s->leading[i], row[n++] = jlt_transfer_finding_density(t, s->leading, i);
        if (s->second != NULL) row[n++] = s->second[i];
        if (t->known != NULL) row[n++] = jlt_transfer_finding_density(t, t->known, i);
        for (unsigned k = 0; k < t->losses; k++)
            if (has_loss[k]) row[n++] = t->lost[i * t->losses + k];
        row[n++] = t->time[i];
        jlt_csv_row(file, row, n);
    }
}

/* The observed order, in the width of boxes, with which the defect of the known density falls from this case to the next finer one;
 * NaN if this case has the finest boxes, or a defect is not positive. */
static double order_of(const jlt_transfer_report *r, size_t i)
{
    const jlt_transfer_case *coarse = &r->cases[i], *fine = i > 0 ? &r->cases[i - 1] : coarse;

    if (fine->noise != coarse->noise || fine->factor >= coarse->factor || !(fmin(fine->finding.defect, coarse->finding.defect) > 0))
        return NAN;
    return log(coarse->finding.defect / fine->finding.defect) / log((double)coarse->factor / (double)fine->factor);
}

static json_t *losses_json(const jlt_transfer_report *r, const jlt_transfer_case *c)
{
    char name[JLT_FATE_TEXT_MAX];
    json_t *lost = json_object();

    for (unsigned k = 0; k < JLT_TRANSFER_SECTION_LOSSES; k++)
        if (occurs(r, k)) json_object_set_new(lost, loss_name(name, r, k), jlt_json_number(c->finding.lost[k]));
    return lost;
}

static json_t *eigenvalues_json(const jlt_transfer_spectrum *s)
{
    json_t *array = json_array();

    for (size_t i = 0; i < s->count; i++)
        json_array_append_new(array, json_pack("{s:o,s:o,s:o,s:o,s:b}", "re", jlt_json_number(s->re[i]), "im",
                                               jlt_json_number(s->im[i]), "residual", jlt_json_number(s->residual[i]), "spread",
                                               jlt_json_number(s->spread[i]), "told", (int)(i < s->told)));
    return array;
}

static json_t *case_json(const jlt_transfer_report *r, size_t i)
{
    const jlt_transfer_case *c = &r->cases[i];
    const jlt_transfer *t = c->transfer;
    const jlt_transfer_finding *f = &c->finding;
    json_t *counts = json_array(), *o = json_object();

    for (unsigned k = 0; k < t->boxes.dim; k++) json_array_append_new(counts, json_integer((json_int_t)t->boxes.count[k]));
    json_object_set_new(o, "counts", counts);
    json_object_set_new(o, "noise", jlt_json_number(c->noise));
    json_object_set_new(o, "boxes", json_integer((json_int_t)t->count));
    json_object_set_new(o, "entries", json_integer((json_int_t)t->row[t->count]));
    if (f->spectrum.count > 0) {
        json_object_set_new(o, "eigenvalues", eigenvalues_json(&f->spectrum));
        json_object_set_new(o, "multiplicity", json_integer((json_int_t)f->multiplicity));
        json_object_set_new(o, "negative", jlt_json_number(f->spectrum.negative));
        json_object_set_new(o, "escape_rate", jlt_json_number(f->escape));
        json_object_set_new(o, "lost", losses_json(r, c));
        json_object_set_new(o, "balance", jlt_json_number(f->balance));
        json_object_set_new(o, "return_time", jlt_json_number(f->time));
        json_object_set_new(o, "asymmetry", jlt_json_number(f->asymmetry));
        json_object_set_new(o, "set_mass", jlt_json_numbers(f->set_mass, 2));
        json_object_set_new(o, "set_kept", jlt_json_numbers(f->set_kept, 2));
    }
    if (r->known != NULL) {
        json_object_set_new(o, "known_defect", jlt_json_number(f->defect));
        json_object_set_new(o, "known_defect_order", jlt_json_number(order_of(r, i)));
        json_object_set_new(o, "known_distance", jlt_json_number(f->distance));
    }
    return o;
}

jlt_status jlt_transfer_report_json(FILE *file, const jlt_transfer_report *r)
{
    const jlt_chart *chart = r->system->flow.chart;
    const jlt_transfer *t = r->cases[0].transfer;
    json_t *o = json_object(), *cases = json_array(), *candidates = json_array(), *names = json_array();

    for (unsigned k = 0; k < chart->dim; k++) json_array_append_new(names, json_string(chart->names[k]));
    for (size_t i = 0; i < r->case_count; i++) json_array_append_new(cases, case_json(r, i));
    for (size_t i = 0; i < r->candidate_count; i++) {
        double q[JLT_BOXES_DIM_MAX];
        jlt_boxes_centre(&t->boxes, q, t->box[r->candidates[i]]);
        json_array_append_new(candidates, jlt_json_numbers(q, chart->dim));
    }
    json_object_set_new(o, "command", jlt_json_string(r->motion->common.command));
    json_object_set_new(o, "model", json_string(r->system->instance->descriptor->model));
    json_object_set_new(o, "table", json_string(r->system->instance->descriptor->sha256));
    json_object_set_new(o, "standing", json_string("evidence, not proof: Ulam's method spreads mass over boxes, and hides weak "
                                                   "dissipation"));
    json_object_set_new(o, "coordinates", names);
    json_object_set_new(o, "backward", json_boolean(r->backwards));
    json_object_set_new(o, "points", json_integer((json_int_t)r->points));
    json_object_set_new(o, "strata", json_integer((json_int_t)r->strata));
    json_object_set_new(o, "seed", json_integer((json_int_t)r->seed));
    json_object_set_new(o, "known", jlt_json_string(r->known));
    json_object_set_new(o, "operators", cases);
    json_object_set_new(o, "candidates", candidates);
    return jlt_json_write(file, o);
}

static void write_spectrum(FILE *stream, const jlt_transfer_report *r, const jlt_transfer_case *c)
{
    const jlt_transfer_finding *f = &c->finding;
    const jlt_transfer_spectrum *s = &f->spectrum;
    char name[JLT_FATE_TEXT_MAX];

    fputs("jellett:   eigenvalues", stream);
    for (size_t i = 0; i < s->told; i++) {
        fprintf(stream, " %.10g", s->re[i]);
        if (s->im[i] != 0) fprintf(stream, "%+.10gi", s->im[i]);
    }
    fputc('\n', stream);
    if (s->told < s->count)
        fprintf(stream, "jellett:   %zu more, up to %.2g in magnitude, are not told: computed once more they are others (0 but for "
                        "rounding, or some of many)\n",
                s->count - s->told, hypot(s->re[s->told], s->im[s->told]));
    if (s->count == 1 && r->wanted > 1 && c->transfer->count > 3)
        fputs("jellett:   no more of them converge: they lie together on a disc or a circle\n", stream);
    if (f->multiplicity > 1)
        fprintf(stream, "jellett:   %zu of them are the leading one within 1e-8: the density is one of many that stay\n",
                f->multiplicity);
    fprintf(stream, "jellett:   escape rate %.6g a return, %.6g per time", f->escape, f->escape / f->time);
    for (unsigned k = 0; k < JLT_TRANSFER_SECTION_LOSSES; k++)
        if (f->lost[k] > 0) fprintf(stream, "; %s %.6g", loss_name(name, r, k), f->lost[k]);
    fprintf(stream, " (balance %.2g)\n", f->balance);
    if (!isnan(f->asymmetry))
        fprintf(stream, "jellett:   distance to the mirror image, which stays under the inverse map: %.6g\n", f->asymmetry);
    if (s->second != NULL && fmin(f->set_mass[0], f->set_mass[1]) > 1e-12)
        fprintf(stream, "jellett:   sets by the sign of the eigenvector of %.10g: of mass %.4g, kept %.6g; of mass %.4g, "
                        "kept %.6g\n",
                s->re[s->second_index], f->set_mass[0], f->set_kept[0], f->set_mass[1], f->set_kept[1]);
}

static void write_known(FILE *stream, const jlt_transfer_report *r, size_t i)
{
    const jlt_transfer_case *c = &r->cases[i];
    const double order = order_of(r, i);

    fprintf(stream, "jellett:   known density %s: distance to its image %.4g", r->known, c->finding.defect);
    if (order > 0) fprintf(stream, ", of order %.2f in the boxes' width", order);
    else if (!isnan(order)) fputs(", less than in narrower boxes, where points are fewer and err more", stream);
    if (!isnan(c->finding.distance)) fprintf(stream, "; to the density above %.4g", c->finding.distance);
    fputc('\n', stream);
}

void jlt_transfer_report_text(FILE *stream, const jlt_transfer_report *r)
{
    const jlt_chart *chart = r->system->flow.chart;

    fprintf(stream, "jellett: %zu points mapped%s, %zu along each coordinate of a box\n", r->points,
            r->backwards ? " backwards" : "", r->strata);
    for (size_t i = 0; i < r->case_count; i++) {
        const jlt_transfer *t = r->cases[i].transfer;
        fputs("jellett: ", stream);
        for (unsigned k = 0; k < chart->dim; k++) fprintf(stream, "%s%zu", k > 0 ? "x" : "", t->boxes.count[k]);
        fprintf(stream, " boxes, noise %.4g: %zu kept, %.1f entries each\n", r->cases[i].noise, t->count,
                (double)t->row[t->count] / (double)t->count);
        if (r->cases[i].finding.spectrum.count > 0) write_spectrum(stream, r, &r->cases[i]);
        if (r->known != NULL) write_known(stream, r, i);
    }
    for (size_t i = 0; i < r->candidate_count; i++) {
        const jlt_transfer *t = r->cases[0].transfer;
        double q[JLT_BOXES_DIM_MAX];
        char digits[JLT_DIGITS_SIZE];
        jlt_boxes_centre(&t->boxes, q, t->box[r->candidates[i]]);
        fprintf(stream, "jellett: dense (%.4g) near --start ",
                jlt_transfer_finding_density(t, r->cases[0].finding.spectrum.leading, r->candidates[i]));
        for (unsigned k = 0; k < chart->dim; k++) {
            jlt_digits_shortest(digits, q[k]);
            fprintf(stream, "%s%s=%s", k > 0 ? "," : "", chart->names[k], digits);
        }
        fputc('\n', stream);
    }
    fputs("jellett: this is evidence, not proof: Ulam's method spreads mass over whole boxes, and hides dissipation and transport "
          "that are weaker\n",
          stream);
}
