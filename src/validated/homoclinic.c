#include "validated/homoclinic_chain.h"
#include "validated/symmetry.h"

void jlt_homoclinic_result_init(jlt_homoclinic_result *result, const jlt_cycle *of, unsigned legs)
{
    *result = (jlt_homoclinic_result){ .legs = legs, .unknowns = of->unknowns, .states = of->formulas->dim };
    jlt_cycle_result_init(&result->saddle, of, 1);
    result->solution = _arb_vec_init((slong)(legs * of->unknowns));
    result->point = _arb_vec_init((slong)result->states);
    result->tangent = _arb_vec_init((slong)result->states);
    arb_init(result->start);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_init(result->least + i);
}

void jlt_homoclinic_result_clear(jlt_homoclinic_result *result)
{
    jlt_cycle_result_clear(&result->saddle);
    _arb_vec_clear(result->solution, (slong)(result->legs * result->unknowns));
    _arb_vec_clear(result->point, (slong)result->states);
    _arb_vec_clear(result->tangent, (slong)result->states);
    arb_clear(result->start);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_clear(result->least + i);
}

/* Whether the orbit begins on the piece of the manifold within N, and not at the saddle. */
static bool begins_in(const jlt_homoclinic_chain *chain, arb_srcptr around, arb_srcptr solution)
{
    bool inside = chain->inside && !arb_contains_zero(chain->start);

    for (unsigned i = 0; i < chain->of->unknowns; i++) inside = inside && arb_contains(around + i, solution + i);
    return inside;
}

/* The tangent at p, from DG dy = (0, ..., 0, 1). Returns false if DG may be singular, or all components of the tangent except the
 * flipped state may be 0. */
static bool find_tangent(jlt_homoclinic_result *result, const jlt_homoclinic_chain *chain)
{
    const slong n = arb_mat_nrows(chain->DG), width = (slong)result->unknowns, bits = jlt_step_bits(chain->of->step);
    bool crosses = false;
    JLT_SCOPED_MATRIX(arb, n, 1, right, dy);

    arb_one(arb_mat_entry(right, n - 1, 0));
    if (arb_mat_solve_precond(dy, chain->DG, right, bits))
        for (unsigned i = 0; i < result->states; i++) {
            arb_zero(result->tangent + i);
            for (slong l = 0; l < width; l++)
                arb_addmul(result->tangent + i, arb_mat_entry(chain->landing, i, l), arb_mat_entry(dy, n - width + l, 0), bits);
            crosses = crosses || (i != chain->flipped && i != chain->question->question->column
                                  && arb_is_nonzero(result->tangent + i));
        }
    return crosses;
}

/* With the saddle proved: the cone, the orbit, the tangent. */
static jlt_status prove(jlt_homoclinic_chain *chain, jlt_homoclinic_result *result)
{
    const jlt_homoclinic_question *question = chain->question;
    JLT_SCOPED_VECTOR(arb, around, (slong)result->unknowns);
    jlt_krawczyk_verdict verdict;
    jlt_krawczyk problem;
    bool determined;
    JLT_SCOPED_MATRIX(arb, 2, 2, A);

    result->verdict = JLT_HOMOCLINIC_NO_CONE;
    JLT_PASS(jlt_homoclinic_chain_local(chain, A, around, &determined));
    if (!determined || !jlt_homoclinic_chain_is_cone(chain, A)) return JLT_OK;
    result->verdict = JLT_HOMOCLINIC_UNSHOWN;
    problem = jlt_homoclinic_chain_equations(chain);
    JLT_PASS(jlt_krawczyk_prove(&problem, &verdict, result->solution, question->box));
    if (verdict == JLT_KRAWCZYK_UNSHOWN) return JLT_OK;
    result->verdict = JLT_HOMOCLINIC_CONTRADICTED;
    if (verdict == JLT_KRAWCZYK_CONTRADICTED) return JLT_OK;
    result->verdict = JLT_HOMOCLINIC_STILL;
    if (!chain->goes_on) return JLT_OK;
    result->verdict = JLT_HOMOCLINIC_OPEN;
    if (!begins_in(chain, around, result->solution) || !chain->meets) return JLT_OK;
    result->verdict = find_tangent(result, chain) ? JLT_HOMOCLINIC_PROVED : JLT_HOMOCLINIC_TANGENT;
    arb_set(result->start, chain->start);
    _arb_vec_set(result->point, chain->point, (slong)result->states);
    for (unsigned i = 0; i < JLT_ARRIVAL_VALIDS_MAX; i++) arf_set(result->least + i, chain->least + i);
    return JLT_OK;
}

jlt_status jlt_homoclinic_prove(jlt_cycle *of, jlt_homoclinic_result *result, const jlt_homoclinic_question *question)
{
    jlt_homoclinic_chain chain;
    bool symmetric = false;

    if (of->unknowns - question->question->level_count != 2 || question->question->free_count != 0) return JLT_ERR_ARG;
    result->verdict = JLT_HOMOCLINIC_NO_SADDLE;
    JLT_PASS(jlt_cycle_prove(of, &result->saddle, question->saddle_box, question->saddle_instant, question->kept));
    if (result->saddle.verdict != JLT_CYCLE_PROVED || !result->saddle.saddle) return JLT_OK;
    result->verdict = JLT_HOMOCLINIC_ASYMMETRIC;
    if (question->signs == NULL || !jlt_symmetry_keeps(of, question->signs)) return JLT_OK;
    JLT_PASS(jlt_symmetry_maps(of, &symmetric, &result->saddle, question->saddle_box, question->saddle_instant, question->signs));
    if (!symmetric) return JLT_OK;
    const bool made = jlt_homoclinic_chain_init(&chain, of, question, result->saddle.solution);
    const jlt_status st = made ? prove(&chain, result) : JLT_OK;
    jlt_homoclinic_chain_clear(&chain);
    return st;
}
