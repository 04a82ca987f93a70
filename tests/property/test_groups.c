/* Which states are 0 only together: the groups that are found by a field's rates against all subsets of the states, of random
 * sparse polynomial fields, whose terms tell which of these the flow keeps at 0. */
#include "unit/check.h"

#include <string.h>

#include "core/random.h"
#include "integrate/signs.h"

enum { DIM_MAX = 6, TERMS = 3, FIELDS = 4000, NONE = DIM_MAX };

/* Each rate is a sum of terms: a coefficient times one state or two. */
typedef struct {
    unsigned dim, count[DIM_MAX], factor[DIM_MAX][TERMS][2];
    double weight[DIM_MAX][TERMS];
} polynomials;

static void evaluate(const double *x, const double *p, double *f)
{
    const polynomials *of = (const polynomials *)(const void *)p;

    for (unsigned i = 0; i < of->dim; i++) {
        f[i] = 0;
        for (unsigned k = 0; k < of->count[i]; k++) {
            const unsigned *factor = of->factor[i][k];
            f[i] += of->weight[i][k] * x[factor[0]] * (factor[1] == NONE ? 1 : x[factor[1]]);
        }
    }
}

static unsigned below(jlt_random *random, unsigned count) { return (unsigned)jlt_random_below(random, count); }

/* Factors ascend, so that no two terms of a rate are of the same states, and cancel. */
static polynomials draw(jlt_random *random)
{
    polynomials of = { .dim = 3 + below(random, DIM_MAX - 2) };

    for (unsigned i = 0; i < of.dim; i++) {
        of.count[i] = 1 + below(random, TERMS);
        for (unsigned k = 0; k < of.count[i]; k++) {
            unsigned *factor = of.factor[i][k];
            factor[0] = below(random, of.dim);
            factor[1] = below(random, 4) == 0 ? NONE : factor[0] + below(random, of.dim - factor[0]);
            of.weight[i][k] = 1 + (double)k / 3;
        }
    }
    return of;
}

/* Whether the flow keeps the states of the set at 0: each term of their rates has one of them. */
static bool is_invariant(const polynomials *of, unsigned set)
{
    for (unsigned i = 0; i < of->dim; i++) {
        for (unsigned k = 0; (set >> i & 1) != 0 && k < of->count[i]; k++) {
            const unsigned *factor = of->factor[i][k];
            if ((set >> factor[0] & 1) == 0 && (factor[1] == NONE || (set >> factor[1] & 1) == 0)) return false;
        }
    }
    return true;
}

/* Whether the set is a least one with one of its states that are not kept alone. */
static bool is_least(const polynomials *of, unsigned set, unsigned kept)
{
    if (!is_invariant(of, set)) return false;
    for (unsigned i = 0; i < of->dim; i++) {
        bool least = ((set & ~kept) >> i & 1) != 0;
        for (unsigned part = (set - 1) & set; part != 0 && least; part = (part - 1) & set)
            least = (part >> i & 1) == 0 || !is_invariant(of, part);
        if (least) return true;
    }
    return false;
}

static unsigned group_of(const jlt_state_groups *groups, unsigned g)
{
    unsigned set = 0;

    for (unsigned k = groups->first[g]; k < groups->first[g + 1]; k++) set |= 1u << groups->member[k];
    return set;
}

static void least_groups_are_found(void **unused)
{
    unsigned shared = 0, all = 0;
    jlt_quantity states[DIM_MAX];
    jlt_random random;

    (void)unused;
    jlt_random_seed(&random, 1);
    for (unsigned i = 0; i < DIM_MAX; i++) states[i] = (jlt_quantity){ .name = "x", .low = -INFINITY, .high = INFINITY };
    for (unsigned n = 0; n < FIELDS; n++) {
        const polynomials of = draw(&random);
        jlt_field field = { .call = evaluate, .p = (const double *)(const void *)&of, .dim = of.dim, .root = -1 };
        unsigned kept = 0, members = 0;
        jlt_signs_find(&field, states);
        for (unsigned i = 0; i < of.dim; i++) {
            kept |= (unsigned)is_invariant(&of, 1u << i) << i;
            assert_int_equal(jlt_state_set_has(&field.kept, i), kept >> i & 1);
        }
        for (unsigned g = 0; g < field.groups.count; g++) {
            const unsigned set = group_of(&field.groups, g);
            assert_true(is_invariant(&of, set) && (set & ~kept) != 0);
            shared += (members & set) != 0;
            members |= set;
        }
        for (unsigned set = 1; set + 1 < 1u << of.dim && field.groups.count < JLT_STATE_GROUPS_MAX; set++) {
            bool found = false;
            if ((set & (set - 1)) == 0 || !is_least(&of, set, kept)) continue;
            for (unsigned g = 0; g < field.groups.count; g++) found = found || group_of(&field.groups, g) == set;
            assert_true(found);
            all++;
        }
    }
    print_message("%u least groups, %u groups that share states with one before\n", all, shared);
    assert_true(shared > FIELDS / 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(least_groups_are_found) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
