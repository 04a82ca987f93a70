/* The dimension of the image of a reduction or an embedding, leaf by leaf: the rank of its derivative along the leaf. */
#include "prove/image.h"
#include "prove/movement.h"
#include "prove/tangent.h"
#include "prove/vanishing.h"

#include <stdlib.h>

/* The rank of a matrix of ratios, shape (rows, columns), by elimination in the field, which overwrites the matrix.
 * minor *= a nonzero minor of this size, up to its sign. */
static size_t rank_of(ttc_task *task, ttc_ratio *matrix, size_t rows, size_t columns, ttc_ratio *minor)
{
    size_t rank = 0;
    ttc_ratio factor;
    ttc_ratio_init(task->ring, &factor);
    for (size_t j = 0; j < columns && rank < rows && ttc_task_open(task); j++) {
        size_t pivot = rank;
        while (pivot < rows && ttc_ratio_is_zero(task->ring, &matrix[pivot * columns + j])) pivot++;
        if (pivot == rows) continue;
        ttc_ratio_multiply(task->ring, minor, minor, &matrix[pivot * columns + j]);
        for (size_t k = 0; k < columns && pivot != rank; k++) {
            ttc_ratio moved = matrix[pivot * columns + k];
            matrix[pivot * columns + k] = matrix[rank * columns + k];
            matrix[rank * columns + k] = moved;
        }
        for (size_t i = rank + 1; i < rows && ttc_task_open(task); i++) {
            if (ttc_ratio_is_zero(task->ring, &matrix[i * columns + j])) continue;
            ttc_ratio_divide(task->ring, &factor, &matrix[i * columns + j], &matrix[rank * columns + j]);
            ttc_ratio_scale(task->ring, &factor, &factor, task->ring->minus_one);
            for (size_t k = j; k < columns; k++)
                ttc_ratio_add_product(task->ring, &matrix[i * columns + k], &factor, &matrix[rank * columns + k]);
        }
        rank++;
    }
    ttc_ratio_clear(task->ring, &factor);
    return rank;
}

static bool mixes(ttc_task *task, const ttc_ratio *value, const bool *moves);

/* Returns true for a root or function of states and parameters together, such as sqrt(x^2 + a) or exp(a*x): for some parameters it
 * may be rational, or depend on others. moves: by variable, whether it changes with the states. */
static bool variable_mixes(ttc_task *task, slong v, const bool *moves)
{
    const ttc_generator *root = ttc_ring_generator(task->ring, v);
    const ttc_model *model = task->model;
    if (!moves[v]) return false;
    if (root != NULL) return mixes(task, &root->square, moves);
    const size_t symbol = ttc_valuation_symbol(task->field, v);
    if (symbol >= model->symbol_count || model->symbols[symbol].definition == TTC_NONE) return false;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    ttc_evaluate(task->field, &value, model->symbols[symbol].definition);
    const bool result = mixes(task, &value, moves);
    ttc_ratio_clear(task->ring, &value);
    return result;
}

static bool mixes(ttc_task *task, const ttc_ratio *value, const bool *moves)
{
    for (slong v = 0; v < (slong)task->ring->variable_count; v++)
        if (ttc_ratio_uses(task->ring, value, v) && (!moves[v] || variable_mixes(task, v, moves))) return true;
    return false;
}

/* polynomial = A + B g becomes the numerator of A^2 - B^2 g^2, which is zero wherever the polynomial is. */
static void take_norm(ttc_task *task, fmpz_mpoly_t polynomial, const ttc_generator *generator)
{
    const fmpz_mpoly_ctx_struct *context = task->ring->context;
    fmpz_mpoly_t without, with, term;
    ttc_ratio norm;
    ttc_ratio_init(task->ring, &norm);
    fmpz_mpoly_init(without, context);
    fmpz_mpoly_init(with, context);
    fmpz_mpoly_init(term, context);
    fmpz_mpoly_derivative(with, polynomial, generator->variable, context);
    fmpz_mpoly_gen(term, generator->variable, context);
    fmpz_mpoly_mul(term, term, with, context);
    fmpz_mpoly_sub(without, polynomial, term, context);
    fmpz_mpoly_mul(without, without, without, context);
    fmpz_mpoly_mul(without, without, generator->square.denominator, context);
    fmpz_mpoly_mul(with, with, with, context);
    fmpz_mpoly_mul(with, with, generator->square.numerator, context);
    fmpz_mpoly_sub(term, without, with, context);
    ttc_ratio_set_polynomial(task->ring, &norm, term);
    fmpz_mpoly_set(polynomial, norm.numerator, context);
    ttc_ratio_clear(task->ring, &norm);
    fmpz_mpoly_clear(term, context);
    fmpz_mpoly_clear(with, context);
    fmpz_mpoly_clear(without, context);
}

/* Remove roots of states and parameters together from a polynomial by norms. Returns false if a function of both remains. */
static bool separate(ttc_task *task, fmpz_mpoly_t polynomial, const bool *moves)
{
    const ttc_ring *ring = task->ring;
    for (size_t i = ring->generator_count; i-- > 0;) /* squares use earlier generators */
        if (fmpz_mpoly_degree_si(polynomial, ring->generators[i].variable, ring->context) > 0 &&
            variable_mixes(task, ring->generators[i].variable, moves))
            take_norm(task, polynomial, &ring->generators[i]);
    for (slong v = 0; v < (slong)ring->variable_count; v++)
        if (fmpz_mpoly_degree_si(polynomial, v, ring->context) > 0 && variable_mixes(task, v, moves)) return false;
    return true;
}

/* Returns true if a level is solved for a parameter by states, so that each of its values may have another part of the level. */
static bool binds_parameter(ttc_task *task)
{
    bool binds = false;
    ttc_ratio value;
    ttc_ratio_init(task->ring, &value);
    for (size_t i = 0; !binds && i < task->model->param_count; i++) {
        ttc_evaluate(task->field, &value, task->model->symbols[task->model->params[i]].node);
        binds = ttc_task_moves(task, &value);
    }
    ttc_ratio_clear(task->ring, &value);
    return binds;
}

/* Gradients, along the leaf's free states, of the expressions given for the target's states and for its parameters. */
typedef struct {
    ttc_tangent tangent;
    ttc_ratio *states, *params; /* shapes (state_rows, tangent.columns), (param_rows, tangent.columns) */
    size_t state_rows, param_rows, rows; /* rows: the number allocated, for each of the two */
} leaf_image;

static bool find_image(ttc_task *task, const ttc_model *target, leaf_image *image)
{
    const ttc_bindings *given = &task->claim->bindings;
    *image = (leaf_image){ .rows = given->count };
    bool ok = ttc_tangent_init(task, &image->tangent);
    image->states = ttc_task_ratios(task, image->rows * image->tangent.columns);
    image->params = ttc_task_ratios(task, image->rows * image->tangent.columns);
    ok = ok && image->states != NULL && image->params != NULL;
    for (size_t i = 0; ok && i < given->count; i++) {
        uint32_t symbol;
        if (!ttc_model_find_symbol(target, task->claim->target_names[i], &symbol)) continue;
        if (target->symbols[symbol].kind == TTC_ROOT) continue;
        const bool is_param = target->symbols[symbol].kind == TTC_PARAM;
        const size_t row = is_param ? image->param_rows++ : image->state_rows++;
        ttc_ratio *place = (is_param ? image->params : image->states) + row * image->tangent.columns;
        ttc_tangent_gradient(task, &image->tangent, place, given->items[i].expression);
    }
    return ok;
}

static void clear_image(ttc_task *task, leaf_image *image)
{
    ttc_task_free(task, image->params, image->rows * image->tangent.columns);
    ttc_task_free(task, image->states, image->rows * image->tangent.columns);
    ttc_tangent_clear(task, &image->tangent);
}

static size_t most_rows(const leaf_image *image) { return 2 * image->rows + image->tangent.constraint_count; }

static void copy_rows(ttc_task *task, ttc_ratio *out, const ttc_ratio *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) ttc_ratio_set(task->ring, &out[i], &rows[i]);
}

/* The ring's variable of the free state of this column. */
static slong free_state(const ttc_task *task, size_t column)
{
    size_t i = 0;
    while (ttc_valuation_is_bound(task->field, task->model->states[i]) || column-- > 0) i++;
    return ttc_valuation_variable(task->field, task->model->states[i]);
}

/* The rows of states and of params, as asked for, and of the constraints of the leaf. count: their number. */
static ttc_ratio *rows_with(ttc_task *task, const leaf_image *image, bool states, bool params, size_t *count)
{
    const size_t n = image->tangent.columns;
    ttc_ratio *matrix = ttc_task_ratios(task, most_rows(image) * n);
    *count = 0;
    if (matrix == NULL) return NULL;
    if (states) copy_rows(task, matrix, image->states, image->state_rows * n);
    *count += states ? image->state_rows : 0;
    if (params) copy_rows(task, matrix + *count * n, image->params, image->param_rows * n);
    *count += params ? image->param_rows : 0;
    copy_rows(task, matrix + *count * n, image->tangent.constraints, image->tangent.constraint_count * n);
    *count += image->tangent.constraint_count;
    return matrix;
}

/* The rank of these rows. minor: a nonzero minor of this size. moves: NULL, or flags of the variables whose columns count. */
static size_t rank_with(ttc_task *task, const leaf_image *image, bool states, bool params, const bool *moves, ttc_ratio *minor)
{
    const size_t n = image->tangent.columns;
    size_t count, rank = 0;
    ttc_ratio *matrix = rows_with(task, image, states, params, &count);
    ttc_ratio_set_integer(task->ring, minor, 1);
    for (size_t i = 0; moves != NULL && i < count * n; i++)
        if (!moves[free_state(task, i % n)]) ttc_ratio_set_integer(task->ring, &matrix[i], 0);
    if (matrix != NULL) rank = rank_of(task, matrix, count, n, minor);
    ttc_task_free(task, matrix, most_rows(image) * n);
    return rank;
}

/* The rank of the products of all these rows with each other. minor: a nonzero minor of this size, by Cauchy and Binet a sum of
 * products of minors of the rows, at least one of which is nonzero where it is. */
static size_t rank_of_products(ttc_task *task, const leaf_image *image, ttc_ratio *minor)
{
    const size_t n = image->tangent.columns;
    size_t count, rank = 0;
    ttc_ratio *rows = rows_with(task, image, true, true, &count), *products = ttc_task_ratios(task, count * count);
    ttc_ratio_set_integer(task->ring, minor, 1);
    for (size_t i = 0; products != NULL && i < count * count * n; i++)
        ttc_ratio_add_product(task->ring, &products[i / n], &rows[i / n / count * n + i % n], &rows[i / n % count * n + i % n]);
    if (products != NULL) rank = rank_of(task, products, count, count, minor);
    ttc_task_free(task, products, count * count);
    ttc_task_free(task, rows, most_rows(image) * n);
    return rank;
}

/* Returns true if the minor, for any values of what does not move, is nonzero for some values of what does: as a polynomial in the
 * latter its coefficients have no common zero. text: NULL, or gets a point at whose parameters it is zero for all values. */
static bool stays(ttc_task *task, const ttc_ratio *minor, const bool *moves, char **text)
{
    fmpz_mpoly_t polynomial;
    fmpz_mpoly_init(polynomial, task->ring->context);
    fmpz_mpoly_set(polynomial, minor->numerator, task->ring->context);
    ttc_search_result result = TTC_POINT_NOT_DECIDED;
    if (separate(task, polynomial, moves)) {
        const bool is_minor = fmpz_mpoly_equal(polynomial, minor->numerator, task->ring->context);
        result = ttc_vanishing_search(task, polynomial, minor->denominator, moves, is_minor ? text : NULL);
    }
    fmpz_mpoly_clear(polynomial, task->ring->context);
    return result == TTC_POINT_IMPOSSIBLE || result == TTC_POINT_EXCLUDED;
}

/* Require that images have the target's dimension for all parameters of both tables: by the minor that shows it for parameters in
 * general, by one with the columns of variables that change on the levels of the target's parameters, or by all minors of the rank
 * together. */
static void require_minor(ttc_task *task, const ttc_model *target, const leaf_image *image, size_t rank, ttc_ratio *minor)
{
    if (ttc_task_moves(task, minor) && binds_parameter(task)) {
        ttc_task_unsettle(task, "a parameter follows from the states on the levels, and for some the image may be of lower "
                                "dimension");
        return;
    }
    bool *moves = ttc_movement_flags(task, target);
    char *point = NULL;
    /* If the rows are those of the states, and independent, their dimension is lower wherever the determinant of products is 0. */
    const bool tells = image->state_rows == rank && image->param_rows == 0 && task->claim->modulo_count == 0;
    if (moves == NULL || !(stays(task, minor, moves, NULL) || (image->tangent.constraint_count == 0 &&
            rank_with(task, image, true, false, moves, minor) == target->state_count && stays(task, minor, moves, NULL)) ||
            (rank_of_products(task, image, minor) == rank && stays(task, minor, moves, tells ? &point : NULL)))) {
        if (point != NULL) ttc_task_refute_at(task, point, NULL, "for these parameters the image is of lower dimension");
        ttc_task_unsettle(task, "for some parameters the image may be of lower dimension");
    }
    if (moves != NULL && ttc_movement_may_be_thin(task, moves))
        ttc_task_unsettle(task, "for some parameters the level may be a point, or another set of lower dimension");
    free(moves);
}

/* The rank of the gradients of the levels on the leaf. */
static size_t rank_of_levels(ttc_task *task)
{
    const ttc_claim *claim = task->claim;
    const size_t n = task->model->state_count;
    ttc_ratio minor;
    ttc_ratio *matrix = ttc_task_ratios(task, claim->modulo_count * n);
    if (matrix == NULL) return 0;
    ttc_ratio_init(task->ring, &minor);
    for (size_t i = 0; i < claim->modulo_count; i++)
        for (size_t j = 0; j < n; j++)
            ttc_evaluate(task->field, &matrix[i * n + j],
                         ttc_derive_state(task->model, task->model->claims[claim->modulo[i]].expression, j));
    const size_t rank = rank_of(task, matrix, claim->modulo_count, n, &minor);
    ttc_ratio_clear(task->ring, &minor);
    ttc_task_free(task, matrix, claim->modulo_count * n);
    return rank;
}

/* Returns true if a point is found at which the minor, unless NULL, and all square roots by which the levels were solved are
 * nonzero: near it the real points of the leaf have the leaf's dimension, and so has their image. */
static bool has_dimension(ttc_task *task, const ttc_ratio *minor)
{
    const size_t mark = ttc_conditions_mark(&task->domain);
    const bool contradictory = task->domain.contradictory;
    for (size_t i = 0; i < task->ring->generator_count && task->claim->modulo_count > 0; i++)
        if (!task->ring->generators[i].positive)
            ttc_conditions_add(&task->domain, &task->ring->generators[i].square, TTC_IS_NONZERO);
    const bool found = ttc_task_search(task, minor, TTC_IS_NONZERO, NULL) == TTC_POINT_FOUND;
    ttc_conditions_rewind(&task->domain, mark, contradictory);
    return found;
}

/* Where a square root by which the levels were solved is zero, the leaf may have real points that are no limits of others of its
 * points, and the image of these a lower dimension. */
static void require_no_thin_part(ttc_task *task)
{
    bool *moves = ttc_vanishing_moves(task);
    if (moves != NULL && ttc_movement_may_be_thin(task, moves))
        ttc_task_unsettle(task, "a part of the level may be of lower dimension, and so may its image");
    free(moves);
}

/* For a reduction, the images of the leaf's states at fixed values of the target's parameters must have the target's dimension; for
 * an embedding, the images must have the leaf's dimension. A leaf whose codimension exceeds the number of levels is no component.
 * If the levels' gradients are independent on it, its points are limits of points of other leaves, and so are their images; if not,
 * real points may be limits of complex ones alone, as those of x = z = 0 are on x^2 y = z^4 where y < 0. */
static void require_dimension(ttc_task *task, const ttc_model *target, const leaf_image *image)
{
    const bool onto = task->claim->kind == TTC_CLAIM_REDUCTION;
    ttc_ratio minor;
    ttc_ratio_init(task->ring, &minor);
    const size_t cut = rank_with(task, image, false, false, NULL, &minor);
    const size_t dimension = image->tangent.columns - cut, codimension = task->model->state_count - dimension;
    const size_t fixed = onto ? rank_with(task, image, false, true, NULL, &minor) : cut;
    const size_t found = rank_with(task, image, true, true, NULL, &minor) - fixed, wanted = onto ? target->state_count : dimension;
    const size_t levels = task->claim->modulo_count;
    if (!ttc_task_open(task) || (codimension > levels && (found == wanted || rank_of_levels(task) == levels))) goto done;
    if (found != wanted) {
        /* Refuted only if the leaf is known to be a component, and an embedding only if its real points have its dimension. */
        if ((codimension <= 1 || rank_of_levels(task) == codimension) && (onto || has_dimension(task, NULL)))
            ttc_task_refute(task, NULL, "the image has dimension %zu, and %s has %zu%s", found,
                            onto ? target->name : task->model->name, wanted,
                            !onto && codimension > 0 ? " on the level" : wanted == 1 ? " state" : " states");
        ttc_task_unsettle(task, "a part of the level, which may lie in a larger one, has an image of dimension %zu, not %zu", found,
                          wanted);
        goto done;
    }
    const bool has = (onto && task->claim->modulo_count == 0) || has_dimension(task, &minor);
    if (onto) require_minor(task, target, image, found + fixed, &minor);
    if (!ttc_task_open(task)) goto done;
    if (!onto && !has) ttc_task_unsettle(task, "no point is known at which the image has the dimension of this table");
    if (!onto && levels > 0) require_no_thin_part(task);
    task->kept += has;
done:
    ttc_ratio_clear(task->ring, &minor);
}

void ttc_prove_dimension(ttc_task *task, const ttc_model *target)
{
    leaf_image image;
    if (find_image(task, target, &image) && ttc_task_open(task)) require_dimension(task, target, &image);
    clear_image(task, &image);
}
