/** A task: the proof of one claim, and the functions that provers of all kinds share.
 *
 *  A claim is about the real points of the table's domain that meet its conditions. They are covered by leaves: on each, some
 *  symbols are expressed through the others, which are free. A prover handles one leaf; each of its requirements is shown for
 *  all points of the leaf, or refuted at a point that is found, or not settled. */
#ifndef TTC_PROVE_TASK_H
#define TTC_PROVE_TASK_H

#include "algebra/derive.h"
#include "algebra/search.h"
#include "prove/prove.h"

typedef struct ttc_task ttc_task;
typedef void (*ttc_prover)(ttc_task *task);

/* Verdicts on the claims of the same table, which a claim may rest on. */
typedef ttc_proof_status (*ttc_verdict_source)(void *context, uint32_t claim);

/* Which conditions of the domain count. */
typedef enum {
    TTC_DOMAIN_WHOLE,
    TTC_DOMAIN_WITHOUT_CLAIM, /* all but divisors of the claim, and of definitions that it alone uses */
    TTC_DOMAIN_OUT_OF_QUESTION, /* all but divisors that depend on symbols under test */
    TTC_DOMAIN_OF_OTHERS /* all but divisors and domain records that depend on symbols under test */
} ttc_domain_extent;

struct ttc_task {
    const ttc_model *model;
    const ttc_claim *claim;
    ttc_divisor_role role; /* with owner: the record whose divisors belong to the domain, as those of the field do */
    uint32_t owner;
    ttc_id divisor;        /* a further divisor, or TTC_NONE */
    ttc_resolver resolver;
    void *resolver_context;
    ttc_verdict_source verdict_of;
    void *verdict_context;
    const ttc_id *levels;  /* shape (level_count,): expressions that are zero at the points in question, besides `claim` */
    size_t level_count;
    const ttc_task *outer; /* of an inner task, often in another table: the task that runs it; NULL: none */
    bool is_lifted;        /* the inner task was run, which is done once for all leaves */
    const ttc_bindings *tested; /* symbols whose own conditions are to be shown; NULL: none, or they have been shown */
    ttc_domain_extent extent;   /* the conditions under which they are to be shown */
    uint32_t tested_root;       /* the root or logarithm whose definition is to be shown positive; 0: none */
    /* of the present leaf */
    ttc_valuation *field;
    ttc_ring *ring;
    ttc_conditions domain;
    const ttc_id *met; /* shape (met_count,): expressions that are zero on the leaf, which excludes some signs of roots */
    size_t met_count;
    uint32_t shown;    /* roots and logarithms before this symbol are not in question, as their conditions were shown */
    bool has_left_out; /* `domain` lacks conditions that use symbols in question: a point found may violate them */
    bool has_point; /* a real point of the leaf is known */
    bool is_thin;   /* the leaf may not be a component of the level on which it lies */
    ttc_id apart;   /* an expression that is zero on all other components, or TTC_NONE */
    ttc_id radical; /* of an invariant alone: the product of the factors of its level, each once; TTC_NONE: not known */
    ttc_valuation *maps[2]; /* maps in use, whose roots are positive as well */
    size_t map_count;
    size_t kept;    /* number of leaves that the flow was shown to keep, whose image was shown to have its dimension, or on which
                       ttc_prove_by_cofactor found a zero */
    char why_empty[160]; /* why the last leaf without points has none; "" if that is not evident */
    bool varies;       /* an integral changes with the states on some leaf */
    bool is_partial;   /* the claim divides by zero on a whole part of the domain, or that was not excluded */
    bool is_integral;  /* an invariant whose level is kept as one of an integral: what is left to show is that it has a point */
    ttc_id unexcluded; /* an expression that must not be zero, and may be for all that is known; TTC_NONE: none */
    ttc_id aside[8];   /* expressions that normal forms divide by: where those from aside_first on are zero, the claim is still to
                          be proved */
    size_t aside_first, aside_count;
    bool is_at_zeros;  /* the leaves lie on one more level, zeros of `unexcluded` or of one of `aside`, where only what is claimed
                          of all points is to be shown */
    bool is_lower;     /* that level may restrict states: dimensions of images are not required there */
    /* the verdict so far */
    ttc_proof_status status;
    bool relies_on_solver;
    bool exhibited;        /* a point proves a claim of existence */
    bool has_smooth_density;
    char *remainder, *point, *note;
};

/* The following functions set the verdict. The format says what is wrong; a ratio, unless NULL, is appended. A refutation is final;
 * the first reason why a claim is not settled is kept, unless the claim is refuted on another leaf. */
TTC_PRINTF(2, 3) void ttc_task_unsettle(ttc_task *task, const char *format, ...);
/* The claim is false at every point of the leaf: refuted if a point is found, else not settled. */
TTC_PRINTF(3, 4) void ttc_task_refute(ttc_task *task, const ttc_ratio *remainder, const char *format, ...);
/* The claim is false at this point, whose text the task then owns. */
TTC_PRINTF(4, 5) void ttc_task_refute_at(ttc_task *task, char *point, const ttc_ratio *remainder, const char *format, ...);
/* Require that a ratio is zero, or stands in this relation to zero, at every point of the leaf. */
TTC_PRINTF(3, 4) void ttc_task_require_zero(ttc_task *task, const ttc_ratio *remainder, const char *format, ...);
TTC_PRINTF(4, 5) void ttc_task_require(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, const char *format, ...);
/* Require left = right at every point of the leaf, each side evaluated in its own valuation. */
TTC_PRINTF(6, 7) void ttc_task_require_equal(ttc_task *task, ttc_valuation *of_left, ttc_id left, ttc_valuation *of_right,
                                             ttc_id right, const char *format, ...);
/* out -= the value of an expression. */
void ttc_task_take_off(ttc_task *task, ttc_ratio *out, ttc_valuation *valuation, ttc_id id);
/* Take over the verdict of an inner task, and what it owns. */
void ttc_task_adopt(ttc_task *task, ttc_task *other);
/* Create a map into the ring of `base`, in which `model` is evaluated, and destroy the last one. Between these calls its roots
 * count as positive, also one that is an element of the field by a choice of sign. NULL, and the claim not settled, when memory is
 * out. */
ttc_valuation *ttc_task_enter_map(ttc_task *task, const ttc_model *model, ttc_valuation *base);
void ttc_task_leave_map(ttc_task *task);
bool ttc_task_open(const ttc_task *task); /* true while nothing is against the claim, and the ring has not failed */

/** Search for a point of the leaf at which a ratio, unless NULL, stands in this relation to zero. text: NULL, or gets the point. */
ttc_search_result ttc_task_search(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, char **text);
/* Returns true if elimination (algebra/elimination.h) alone shows that at no point of the leaf the ratio stands in this relation to
 * zero, also where denominators of conditions vanish. Returns false if the ratio's own denominator may vanish. */
bool ttc_task_never_is(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation);
/* The signs that a ratio has at a few simple points of the leaf. */
unsigned ttc_task_signs_met(ttc_task *task, const ttc_ratio *ratio);
/* Search for a point of the leaf at which a ratio does not stand in this relation to zero. That there is none may hold but for
 * points put `aside`. */
ttc_search_result ttc_task_search_against(ttc_task *task, const ttc_ratio *ratio, ttc_relation relation, char **text);
/* The text of a point of the leaf at which a state has this value; NULL if none is found. */
char *ttc_task_point_with(ttc_task *task, uint32_t state, const fmpq_t value);
/* The text of a point of the leaf at which a value is zero, between two of its signs; NULL if none is found. */
char *ttc_task_zero_of(ttc_task *task, const ttc_ratio *value);
/* A polynomial as an expression of the table; TTC_NONE if it uses spare symbols, which have no value on other leaves. */
ttc_id ttc_task_expression(ttc_task *task, const fmpz_mpoly_struct *polynomial);
/* Note that where this denominator of a normal form is zero the claim, one of all points, is still to be proved, on leaves of their
 * own. Returns false if that cannot be, as the denominator is no expression of the table, or too many are put aside. */
bool ttc_task_put_aside(ttc_task *task, const fmpz_mpoly_struct *denominator);
/* Returns true unless it is known that the leaf has no points: a root adjoined since may have the sign that leaves none. */
bool ttc_task_may_have_point(ttc_task *task);

/** Run `prover` on every leaf and draw the verdict. Leaves are given by the claim's `when` and the family's, the family's states,
 *  the zero levels of `modulo`, each of their factors, and each sign of a root whose radicand became a square. */
void ttc_task_run(ttc_task *task, ttc_prover prover);

/* Returns true if the claim's `when` restricts states, so that it holds on no open set of them. */
bool ttc_task_restricts_states(const ttc_task *task);

/* The equilibria claim that a claim is about: itself, or its family; NULL for other kinds. */
const ttc_claim *ttc_task_family(const ttc_task *task);

/* The signs that an expression has at a few points of the leaf, in balls. */
unsigned ttc_task_signs_at_points(ttc_task *task, ttc_id id);

/* out = the entry of the Jacobian of the field. */
void ttc_task_jacobian(ttc_task *task, ttc_ratio *out, size_t row, size_t column);
/* Require left = right at every point of the leaf: by quick tests, then exactly, and if that grows too large at one point. what:
 * the difference, in words. */
void ttc_task_require_identity(ttc_task *task, ttc_id left, ttc_id right, const char *what);
/* Make all roots and other functions that are not bound free variables. Returns their number. */
size_t ttc_free_functions(ttc_valuation *valuation);
/* A quick test: returns true if the rate of an expression along the flow is `rate`, computed in other states: lets that are linear
 * in some states and all divide by one sum replace these states, as velocities, which divide by the determinant of the inertia,
 * replace momenta. */
bool ttc_task_has_rate_in_other_states(ttc_task *task, ttc_id expression, ttc_id rate);
/** Try to refute that an expression is zero at one point of the leaf in ball arithmetic, without algebra: where the remainder
 *  cannot be computed, or takes too long. The ring may have failed. Returns true if it is refuted; else the ring is as it was. */
bool ttc_task_refute_at_point(ttc_task *task, ttc_id id, const char *name);
/* Try the same with a symmetry, reversor or period for which the ring has failed, as it maps a function to one that is missing. */
void ttc_task_refute_map_at_point(ttc_task *task);
/* Returns true if an expression is found, in the same way, to change with a state at one point of the leaf, whose conditions do not
 * restrict the states. */
bool ttc_task_moves_at_point(ttc_task *task, ttc_id id);
/* Returns true if a ratio changes with the states. */
bool ttc_task_moves(ttc_task *task, const ttc_ratio *ratio);
/* An array of zeros, shape (count,), for ttc_task_free. NULL, and the claim not settled, when memory is out. */
ttc_ratio *ttc_task_ratios(ttc_task *task, size_t count);
void ttc_task_free(ttc_task *task, ttc_ratio *ratios, size_t count);

/* Returns true for a cosine whose sine is zero: its rate, a multiple of the sine, is zero at whatever rate its angle changes. */
bool ttc_task_is_at_turn(ttc_task *task, const ttc_symbol_entry *entry);

/* Require that the flow keeps the set that the leaf describes, that is, is tangent to it. hint: NULL, or advice for a condition
 * that is not kept, with which the claim is then not settled. */
void ttc_task_require_kept(ttc_task *task, const char *hint);

/* Require that the image of the leaf under a reduction to `target` has the target's dimension, under an embedding the leaf's. */
void ttc_prove_dimension(ttc_task *task, const ttc_model *target);

/* Require that the flow keeps the expression which is given for a parameter of another table, of this name. */
void ttc_prove_constant(ttc_task *task, const char *name, ttc_id expression);
/* Require that what `claim` gives for states of the target, the model of `map`, has the target's rates; and that what both models
 * observe, hold valid, or claim as an integral under one name is one quantity. */
void ttc_prove_chain_rule(ttc_task *task, const ttc_claim *claim, ttc_valuation *map);
void ttc_prove_same_observations(ttc_task *task, ttc_valuation *map);

/* Require that an integral has the same value at points that differ by the periods which the table claims, except that of state
 * `but`, which was eliminated; UINT32_MAX: of none. */
void ttc_prove_level_is_periodic(ttc_task *task, const ttc_claim *integral, uint32_t but);

/* Returns true if the expression of an invariant is shown to be constant along all motions of the level to which it is restricted:
 * each of its own levels is then kept, whatever its components are. */
bool ttc_prove_is_integral(ttc_task *task);
/* Settle an invariant f that does not divide, whose level cannot be solved. It is refuted at a point of the level at which df/dt is
 * not zero. It is proved if the level has a point, and df/dt = K f with a cofactor K that is finite all over the domain: along a
 * motion f is then multiplied by exp of the integral of K (G. Darboux, Bull. Sci. Math. 2, 1878). An `equal` or a `rate` modulo
 * one such f is settled in the same way, with the difference of its sides in place of df/dt and the product of the factors of f in
 * place of f, if no divisor of the claim is zero on a whole part of the level. */
void ttc_prove_by_cofactor(ttc_task *task);

/* The provers, one for each kind of claim. */
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
