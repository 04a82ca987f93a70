/** The domain of a table as conditions on the points of a leaf: parameters within their signs, states within their intervals,
 *  radicands of roots positive, domain records, and nothing that is divided by zero. */
#ifndef TTC_DOMAIN_H
#define TTC_DOMAIN_H

#include "prove/prove_task.h"

/* Adds the conditions of the domain to task->domain. Symbols under test (task->tested, task->tested_root) and the roots that
 * depend on them are left out: theirs is what the claim has to show. */
void ttc_domain_add(ttc_task *task, ttc_conditions *conditions, ttc_domain_extent extent);

/* Adds the signs of the cosine and the sine of an angle, where the intervals of states tell them. */
void ttc_domain_add_angle(ttc_task *task, ttc_conditions *conditions, uint32_t cosine);

/* The relation to zero that a parameter's sign condition states. Not to be asked of a parameter without one. */
ttc_relation ttc_domain_relation(ttc_sign sign);

/* Requires of the value of a symbol what its record says of it; map: NULL, or the valuation in which `model` is seen. */
void ttc_domain_require_symbol(ttc_task *task, ttc_valuation *map, const ttc_model *model, uint32_t symbol, const char *where);

/* Requires everything that the domain of `model`, seen through `map`, demands: of an image under a map. */
void ttc_domain_require_image(ttc_task *task, ttc_valuation *map, const ttc_model *model, const char *where);

/* Requires of a root of another model, given as an expression, that its square is the radicand and that it is positive. */
void ttc_domain_require_root(ttc_task *task, ttc_valuation *map, const ttc_symbol_entry *entry);

/* Requires that no divisor of this role and owner is zero, seen through `map`, and none of the definitions in `used`, by symbol. */
void ttc_domain_require_divisors(ttc_task *task, ttc_valuation *map, const ttc_model *model, ttc_divisor_role role, uint32_t owner,
                                 const unsigned char *used, const char *where);

/* Whether the table divides by what depends on symbols under test, and whether domain records do. */
bool ttc_domain_divides_by_tested(const ttc_task *task);
bool ttc_domain_speaks_of_tested(const ttc_task *task);

/* Requires of a variant's parameters what their records say, and the domain records that speak of parameters alone; and that the
 * field divides by nothing that they make zero everywhere. */
void ttc_domain_require_tested(ttc_task *task);
void ttc_domain_require_field(ttc_task *task);

/* Whether an expression depends on symbols under test, and on no state. */
bool ttc_domain_is_of_tested(const ttc_task *task, ttc_id id);

/* The symbols that the claim and the domain use, as the table is written: by symbol, for free(); NULL when memory is out. */
unsigned char *ttc_domain_support(const ttc_task *task, ttc_domain_extent extent);

/* Which divisors of the table the claim alone brings in, by their number, for free(); NULL when memory is out. */
unsigned char *ttc_domain_divisors_of_claim(const ttc_task *task);

#endif
