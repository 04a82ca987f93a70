/** What the provers of the claim kinds share: one claim, in one field, in one subcase of what its conditions allow.
 *
 *  A claim is about the real points of the table's domain that meet its conditions. They are covered by leaves: on each, some
 *  symbols follow from the others, which are free. A prover looks at one leaf; what it requires there is either shown for all
 *  points of the leaf, or refuted at one that is exhibited, or not settled. */
#ifndef TTC_PROVE_TASK_H
#define TTC_PROVE_TASK_H

#include "algebra/derive.h"
#include "algebra/search.h"
#include "prove/prove.h"

typedef struct ttc_task ttc_task;
typedef void (*ttc_prover)(ttc_task *task);

/* Verdicts on the claims of the same table, which a claim may rest on. */
typedef ttc_proof_status (*ttc_verdict_source)(void *context, uint32_t claim);

typedef enum {
    TTC_DOMAIN_WHOLE,
    TTC_DOMAIN_WITHOUT_CLAIM, /* without what the claim alone divides by, itself and by the definitions that it uses */
    TTC_DOMAIN_OUT_OF_QUESTION, /* without divisors that depend on symbols under test */
    TTC_DOMAIN_OF_OTHERS /* nor domain records that do */
} ttc_domain_extent;

struct ttc_task {
    const ttc_model *model;
    const ttc_claim *claim;
    ttc_divisor_role role; /* with owner: whose divisors count, beside those of the field */
    uint32_t owner;
    ttc_id divisor;        /* one more, or TTC_NONE */
    ttc_resolver resolver;
    void *resolver_context;
    ttc_verdict_source verdict_of;
    void *verdict_context;
    const ttc_id *levels;  /* shape (level_count,): zero at the points that are meant, beside what the claim says of them */
    size_t level_count;
    const ttc_task *outer; /* in another table: the claim that it is looked at for; NULL */
    bool is_lifted;        /* the other table, or what is asked elsewhere, was looked at: once for all leaves */
    const ttc_bindings *tested; /* symbols whose own conditions are what is to be shown; NULL: none, or they have been shown */
    ttc_domain_extent extent;   /* in which that is to be shown */
    uint32_t tested_root;       /* the root whose radicand is to be shown positive; 0: none */
    /* of the leaf in hand */
    ttc_valuation *field;
    ttc_ring *ring;
    ttc_conditions domain;
    uint32_t shown;    /* roots and logarithms before this symbol are no longer in question: theirs was shown here */
    bool has_left_out; /* conditions of the domain that use what is in question: a point may violate them */
    bool has_point; /* a real point of the leaf is known */
    bool is_thin;   /* the leaf may be no component of the level that it lies on */
    bool is_hidden; /* it is none, or one whose component has no other real points */
    ttc_id apart;   /* not zero at points that belong to no other component, or TTC_NONE */
    ttc_valuation *maps[2]; /* other models, or ours elsewhere, seen from here: their roots are positive as well */
    size_t map_count;
    size_t kept;    /* leaves that the flow was shown to keep, or whose image was shown to have its dimension */
    char why_empty[160]; /* what keeps the last empty leaf from having points; "" where that is not evident */
    /* the verdict so far */
    ttc_proof_status status;
    bool relies_on_solver;
    bool exhibited;        /* by a claim that something exists */
    bool has_smooth_density;
    char *remainder, *point, *note;
};

/* Against a claim. The format names what is wrong; a ratio, when given, is appended. A refutation stays; the first reason why
 * a claim is not settled stays as well, unless it is refuted on another leaf. */
TTC_PRINTF(2, 3) void ttc_task_unsettle(ttc_task *task, const char *format, ...);
/* False at every point of this leaf. */
TTC_PRINTF(3, 4) void ttc_task_refute(ttc_task *task, const ttc_ratio *remainder, const char *format, ...);
/* False at a point that was found, which then belongs to the task. */
TTC_PRINTF(4, 5) void ttc_task_refute_at(ttc_task *task, char *point, const ttc_ratio *remainder, const char *format, ...);
/* Zero at every point of this leaf. */
TTC_PRINTF(3, 4) void ttc_task_require_zero(ttc_task *task, const ttc_ratio *remainder, const char *format, ...);
/* In its relation to zero at every point of this leaf. */
TTC_PRINTF(4, 5) void ttc_task_require(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, const char *format, ...);
/* What was found of a task that this one rests on, and what it holds then belongs to us. */
void ttc_task_adopt(ttc_task *task, ttc_task *other);
/* A map is looked at until it is left: whichever sign makes one of its roots rational here, it is positive. */
void ttc_task_enter_map(ttc_task *task, ttc_valuation *map);
void ttc_task_leave_map(ttc_task *task);
bool ttc_task_open(const ttc_task *task); /* nothing against the claim so far, and the ring is sound */

/** Look for a point of the leaf at which a ratio stands in a relation to zero. text, when not NULL, receives the point. */
ttc_search_result ttc_task_search(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, char **text);
/* Whether the leaf is not known to have none: a root that has come in since may have got the sign that leaves none. */
bool ttc_task_may_have_point(ttc_task *task);

/** Run `prover` on every leaf: the claim's `when` and the family's, the family's states, the zero levels of its `modulo`, each
 *  of their factors, each sign of a root whose radicand became a square; then draw the verdict. */
void ttc_task_run(ttc_task *task, ttc_prover prover);

/* The claim's conditions say something of the states, so that they hold on no open set of them. */
bool ttc_task_restricts_states(const ttc_task *task);

/* The equilibria claim that a claim is about: itself, or its family; NULL for other kinds. */
const ttc_claim *ttc_task_family(const ttc_task *task);

/* out = the entry of the Jacobian of the field. */
void ttc_task_jacobian(ttc_task *task, ttc_ratio *out, size_t row, size_t column);
/* Whether an expression is zero, roots being taken for independent variables: a quick way, by which only `true` says anything. */
bool ttc_task_is_zero_for_any_roots(ttc_task *task, ttc_id id);
/** Refutes that an expression is zero, at one point of the leaf and in balls, without any algebra: for tables with so many roots
 *  that the remainder would be out of reach. True when it has. */
bool ttc_task_refute_at_point(ttc_task *task, ttc_id id, const char *name);
/* Whether a ratio changes with the states. */
bool ttc_task_moves(ttc_task *task, const ttc_ratio *ratio);
/* shape (count,), zeros; for ttc_task_free. NULL, and not settled, when memory is out. */
ttc_ratio *ttc_task_ratios(ttc_task *task, size_t count);
void ttc_task_free(ttc_task *task, ttc_ratio *ratios, size_t count);

/* The symbol is a cosine that is bound to 1 or -1: its rate, a multiple of the sine, is zero however its angle moves. */
bool ttc_task_is_at_turn(ttc_task *task, const ttc_symbol_entry *entry);

/* The flow keeps the set that this leaf describes: it is tangent to it. hint: NULL, or what to do about a condition that is not
 * kept, which then leaves the claim not settled. */
void ttc_task_require_kept(ttc_task *task, const char *hint);

/* The image of the leaf under a reduction to `target` has the dimension of the target, under an embedding that of the leaf. */
void ttc_prove_dimension(ttc_task *task, const ttc_model *target);

/* A parameter of another table, of that name, given as an expression is a quantity that our flow keeps. */
void ttc_prove_constant(ttc_task *task, const char *name, ttc_id expression);
/* What `claim` gives for states of `target`, bound in `map`, moves as the target says; and what both models observe,
 * hold valid, or claim as an integral under one name is one quantity. */
void ttc_prove_chain_rule(ttc_task *task, const ttc_claim *claim, const ttc_model *target, ttc_valuation *map);
void ttc_prove_same_observations(ttc_task *task, const ttc_model *target, ttc_valuation *map);

/* A level of this integral is one of points that differ by the periods that the table claims; but: of this state it may change with
 * the period, as it has gone, or UINT32_MAX. */
void ttc_prove_level_is_periodic(ttc_task *task, const ttc_claim *integral, uint32_t but);

/* The provers, one a kind. */
void ttc_prove_integral(ttc_task *task);
void ttc_prove_rate(ttc_task *task);
void ttc_prove_invariant(ttc_task *task);
void ttc_prove_measure(ttc_task *task);
void ttc_prove_reversor(ttc_task *task);
void ttc_prove_symmetry(ttc_task *task);
void ttc_prove_equilibria(ttc_task *task);
void ttc_prove_trace(ttc_task *task);
void ttc_prove_charpoly(ttc_task *task);
void ttc_prove_obstructs(ttc_task *task);
void ttc_prove_matrix(ttc_task *task);
void ttc_prove_left_null(ttc_task *task);
void ttc_prove_equal(ttc_task *task);
void ttc_prove_positive(ttc_task *task);
void ttc_prove_reduction(ttc_task *task);
void ttc_prove_section(ttc_task *task);
void ttc_prove_descent(ttc_task *task);
void ttc_prove_lift(ttc_task *task);
void ttc_prove_pole(ttc_task *task);

#endif
