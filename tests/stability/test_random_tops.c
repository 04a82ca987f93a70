/* The first cases of stability.test_random_tops_slow, and those that have failed: README.md here says how. */
#include "stability/random_tops/trial.h"

static const unsigned long failed[][2] = { { 1, 179 },   { 4, 47 },    { 12, 374 },  { 21, 8 },    { 21, 624 },  { 21, 717 },
                                           { 21, 1642 }, { 31, 2424 }, { 31, 3265 }, { 31, 5867 }, { 31, 6847 }, { 31, 8254 },
                                           { 41, 1698 }, { 41, 4660 }, { 41, 4929 }, { 41, 8888 }, { 51, 3773 }, { 51, 7110 },
                                           { 51, 9974 }, { 61, 684 },  { 61, 903 },  { 61, 3901 }, { 71, 6928 }, { 81, 5831 },
                                           { 81, 8215 }, { 91, 3820 }, { 1, 891 },   { 102, 1844 }, { 1, 1981 } };

int main(void)
{
    bool broken = trial_run(1, 60, 0);
    for (size_t i = 0; i < sizeof failed / sizeof *failed; i++) broken |= trial_run(failed[i][0], 1, failed[i][1]);
    return broken;
}
