/* Every piece of a study is of one shard, and costs that are uneven are shared. */
#include "unit/check.h"

#include "shards/deal.h"

enum { PIECES_MAX = 1300, TURNS = 1000 };

static void each_piece_once(void **state)
{
    static const size_t pieces[] = { 0, 1, 2, 7, 64, 1299, 1300 }, shards[] = { 1, 2, 3, 4, 5, 16, 17, 100, 2000 };

    (void)state;
    for (size_t i = 0; i < sizeof pieces / sizeof *pieces; i++)
        for (size_t j = 0; j < sizeof shards / sizeof *shards; j++) {
            unsigned char met[PIECES_MAX] = { 0 };
            size_t all = 0;
            for (size_t shard = 0; shard < shards[j]; shard++) {
                const size_t own = jlt_deal_count(shard, shards[j], pieces[i]);
                assert_in_range(own, pieces[i] / shards[j], pieces[i] / shards[j] + 1);
                for (size_t place = 0; place < own; place++, all++) {
                    const size_t piece = jlt_deal_piece(place, shard, shards[j]);
                    assert_true(piece < pieces[i]);
                    assert_int_equal(met[piece]++, 0);
                }
            }
            assert_int_equal(all, pieces[i]);
        }
}

/* Pieces cost e^(20 x) at x of a parameter from 0 to 1, so that a twentieth of them is most of the work. Those of one turn are in a
 * ratio of at most e^(20 / TURNS). */
static void neighbours_are_shared(void **state)
{
    (void)state;
    for (size_t shards = 2; shards <= 13; shards++) {
        double sum = 0, most = 0;
        for (size_t shard = 0; shard < shards; shard++) {
            double own = 0;
            for (size_t place = 0; place < TURNS; place++)
                own += exp(20.0 * (double)jlt_deal_piece(place, shard, shards) / (double)(TURNS * shards));
            sum += own;
            most = fmax(most, own);
        }
        assert_true(most <= exp(20.0 / TURNS) * sum / (double)shards);
    }
}

/* Every N-th piece is of the same part of a grid: of TURNS a shard draws it one time in N, within five standard deviations. */
static void no_part_is_one_shards(void **state)
{
    (void)state;
    for (size_t shards = 2; shards <= 13; shards++)
        for (size_t shard = 0; shard < shards; shard++) {
            const double share = 1.0 / (double)shards;
            double count = 0;
            for (size_t place = 0; place < TURNS; place++) count += jlt_deal_piece(place, shard, shards) % shards == 0;
            assert_true(fabs(count - TURNS * share) < 5 * sqrt(TURNS * share * (1 - share)));
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_piece_once),
        cmocka_unit_test(neighbours_are_shared),
        cmocka_unit_test(no_part_is_one_shards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
