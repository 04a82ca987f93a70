/* Chooses frame, cone and radii for the proof of a homoclinic orbit, and refines a guess of the orbit. */
#include "validated/homoclinic_chain.h"
#include "validated/symmetry.h"

#include <math.h>

enum { CONES = 12 };

static double middle(const arb_t value) { return arf_get_d(arb_midref(value), ARF_RND_NEAR); }

/* Columns of length 1 close to the eigenvectors of D, that of the larger multiplier first. Returns false if D has no such frame. */
static bool choose_frame(arb_ptr frame, const arb_mat_t D)
{
    const double a = middle(arb_mat_entry(D, 0, 0)), b = middle(arb_mat_entry(D, 0, 1)), c = middle(arb_mat_entry(D, 1, 0)),
                 d = middle(arb_mat_entry(D, 1, 1)), half = (a + d) / 2, root = sqrt(half * half - a * d + b * c);
    const double values[] = { half + (half < 0 ? -root : root), half - (half < 0 ? -root : root) };

    for (unsigned k = 0; k < 2; k++) {
        const bool first = fabs(a - values[k]) + fabs(b) > fabs(c) + fabs(d - values[k]); /* the longer row of D - value */
        const double x = first ? -b : d - values[k], y = first ? a - values[k] : -c, length = hypot(x, y);
        arb_set_d(frame + k, x / length);
        arb_set_d(frame + 2 + k, y / length);
        if (!(length > 0)) return false;
    }
    return true;
}

/* The derivative D of the return map at the midpoint of the saddle's box. */
static jlt_status look(jlt_cycle *of, arb_mat_t D, const jlt_homoclinic_question *q)
{
    JLT_SCOPED_VECTOR(arb, y, (slong)of->unknowns);

    for (unsigned i = 0; i < of->unknowns; i++) arb_get_mid_arb(y + i, q->saddle_box + i);
    JLT_PASS(jlt_cycle_map_arrive(of, y, arb_midref(q->saddle_instant), q->question->direction, NULL));
    return jlt_cycle_map_restrict(of, D, y, q->kept) ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* Choose a slope for which the cone is mapped into its interior. The least such slope depends on A over N, which grows with the
 * slope, so a few are tried. */
static jlt_status choose_cone(jlt_homoclinic_chain *chain, jlt_homoclinic_question *q)
{
    JLT_SCOPED_VECTOR(arb, around, (slong)chain->of->unknowns);
    bool determined, is_cone = false;
    JLT_SCOPED_MATRIX(arb, 2, 2, A);

    arb_set(q->slope, q->reach);
    for (unsigned attempt = 0; attempt < CONES && !is_cone; attempt++) {
        JLT_PASS(jlt_homoclinic_chain_local(chain, A, around, &determined));
        is_cone = determined && jlt_homoclinic_chain_is_cone(chain, A);
        if (is_cone) break;
        JLT_SCOPED(mag, least);
        arb_get_mag(least, arb_mat_entry(A, 1, 0));
        mag_mul_2exp_si(least, least, 2);
        arb_mul_2exp_si(q->slope, q->slope, 1);
        if (mag_cmp_2exp_si(least, 0) < 0 && determined) {
            arf_set_mag(arb_midref(around), least);
            mag_zero(arb_radref(around));
            arb_max(q->slope, q->slope, around, 53);
        }
    }
    return is_cone ? JLT_OK : JLT_ERR_NO_CONVERGENCE;
}

/* Set the radii of the boxes to 4 times the least that Krawczyk's operator needs, plus the rounding of the midpoints. */
static jlt_status choose_radii(jlt_homoclinic_chain *chain, jlt_homoclinic_question *q)
{
    const jlt_krawczyk problem = jlt_homoclinic_chain_equations(chain);
    const slong n = problem.n;
    JLT_SCOPED_MATRIX(arb, n, 1, G);
    JLT_SCOPED_MATRIX(arb, n, n, DG, M);

    JLT_PASS(problem.equations(problem.context, G, DG, q->box));
    if (!jlt_krawczyk_invert(M, DG, problem.bits)) return JLT_ERR_NO_CONVERGENCE;
    arb_mat_mul(G, M, G, problem.bits);
    for (slong i = 0; i < n; i++) {
        JLT_SCOPED(mag, rounding);
        arb_get_mag(arb_radref(q->box + i), arb_mat_entry(G, i, 0));
        mag_mul_2exp_si(arb_radref(q->box + i), arb_radref(q->box + i), 2);
        mag_set_ui_2exp_si(rounding, 1, -(slong)(3 * q->question->digits));
        mag_add(arb_radref(q->box + i), arb_radref(q->box + i), rounding);
    }
    return JLT_OK;
}

/* Returns UNSUPPORTED unless the reversor is proved to map section, levels and saddle to themselves. */
static jlt_status look_at_reversor(jlt_cycle *of, const jlt_cycle_result *saddle, const jlt_homoclinic_question *q)
{
    bool symmetric = false;
    jlt_status st = JLT_OK;

    if (jlt_symmetry_keeps(of, q->signs))
        st = jlt_symmetry_maps(of, &symmetric, saddle, q->saddle_box, q->saddle_instant, q->signs);
    return st != JLT_OK || symmetric ? st : JLT_ERR_UNSUPPORTED;
}

jlt_status jlt_homoclinic_make(jlt_cycle *of, jlt_homoclinic_question *q)
{
    jlt_homoclinic_chain chain;
    jlt_cycle_result saddle;
    jlt_krawczyk problem;
    bool has_chain = false;
    jlt_status st;
    JLT_SCOPED_MATRIX(arb, 2, 2, D);

    jlt_cycle_result_init(&saddle, of, 1);
    JLT_TRY(jlt_cycle_prove(of, &saddle, q->saddle_box, q->saddle_instant, q->kept));
    JLT_TRY(look(of, D, q));
    st = JLT_ERR_NO_CONVERGENCE;
    if (saddle.verdict != JLT_CYCLE_PROVED || !saddle.saddle || !choose_frame(q->frame, D)) goto done;
    JLT_TRY(look_at_reversor(of, &saddle, q));
    st = JLT_ERR_NO_CONVERGENCE;
    arb_one(q->reach);
    arb_zero(q->slope);
    has_chain = true;
    if (!jlt_homoclinic_chain_init(&chain, of, q, saddle.solution)) goto done;
    chain.adjusts = true;
    problem = jlt_homoclinic_chain_equations(&chain);
    JLT_TRY(jlt_krawczyk_refine(&problem, q->box, 2.6 * q->question->digits));
    chain.adjusts = false;
    _arb_vec_set(q->instants, chain.own_instants, (slong)q->legs);
    arb_set_d(q->reach, 1.25 * fabs(middle(chain.start)));
    JLT_TRY(choose_cone(&chain, q));
    st = choose_radii(&chain, q);
done:
    if (has_chain) jlt_homoclinic_chain_clear(&chain);
    jlt_cycle_result_clear(&saddle);
    return st;
}
