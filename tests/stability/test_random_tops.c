/* The first cases of stability.test_random_tops_slow. */
#include "stability/random_tops/trial.h"

int main(void)
{
    return trial_run(1, 60, 0);
}
