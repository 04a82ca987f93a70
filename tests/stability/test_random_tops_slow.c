/* Random tops through jellett against quadruple precision: SEED CASES FIRST; README.md here has what it found. */
#include <stdlib.h>

#include "stability/random_tops/trial.h"

int main(int argc, char **argv)
{
    return trial_run(argc > 1 ? strtoul(argv[1], NULL, 10) : 1, argc > 2 ? strtoul(argv[2], NULL, 10) : 2000,
                     argc > 3 ? strtoul(argv[3], NULL, 10) : 0);
}
