/* roessler: its table byte for byte (SHA-256 7d2f97bb2c6d3f82c3ce5d0578ec3d5df1852a1298f7e68780337a2d6518941e), what is proved of it, its descriptors. Written by ttc 0.1.0; do not edit. */
#include "kernel_abi.h"

extern const char jlt_table_roessler[];
extern const jlt_claim jlt_claims_roessler[];
extern const jlt_descriptor *const jlt_family_roessler[];

const char jlt_table_roessler[] = {
    '#',' ','R','o','e','s','s','l','e','r','\'','s',' ','s','y','s','t','e','m',',',' ','f','o','r',' ','c','h','e','c','k','s',' ','o','f',' ','i','n','t','e','g','r','a','t','o','r','s',' ','a','n','d',' ','o','f',' ','e','v','e','r','y','t','h','i','n','g',' ','t','h','a','t',' ','f','i','n','d','s',' ','o','r','b','i','t','s','.','\n',
    '\n',
    'm','o','d','e','l',' ','r','o','e','s','s','l','e','r','\n',
    't','i','t','l','e',' ','"','R','o','e','s','s','l','e','r','\'','s',' ','s','y','s','t','e','m','"','\n',
    's','o','u','r','c','e',' ','"','O','.',' ','E','.',' ','R','o','e','s','s','l','e','r',',',' ','A','n',' ','e','q','u','a','t','i','o','n',' ','f','o','r',' ','c','o','n','t','i','n','u','o','u','s',' ','c','h','a','o','s',',',' ','P','h','y','s','.',' ','L','e','t','t','.',' ','A',' ','5','7',' ','(','1','9','7','6',')',' ','3','9','7','-','3','9','8','"','\n',
    '\n',
    'p','a','r','a','m',' ','a',' ','!','=',' ','0','\n',
    'p','a','r','a','m',' ','b','\n',
    'p','a','r','a','m',' ','c','\n',
    'd','e','f','a','u','l','t',' ','a',' ','=',' ','0','.','2',',',' ','b',' ','=',' ','0','.','2',',',' ','c',' ','=',' ','5','.','7','\n',
    '\n',
    's','t','a','t','e',' ','x','\n',
    's','t','a','t','e',' ','y','\n',
    's','t','a','t','e',' ','z','\n',
    '\n',
    'e','q',' ','x',' ','=','\n',
    ' ',' ',' ',' ','-',' ','y','\n',
    ' ',' ',' ',' ','-',' ','z','\n',
    'e','q',' ','y',' ','=','\n',
    ' ',' ',' ',' ','+',' ','x','\n',
    ' ',' ',' ',' ','+',' ','a','*','y','\n',
    'e','q',' ','z',' ','=','\n',
    ' ',' ',' ',' ','+',' ','b','\n',
    ' ',' ',' ',' ','+',' ','x','*','z','\n',
    ' ',' ',' ',' ','-',' ','c','*','z','\n',
    '\n',
    'e','q','u','i','l','i','b','r','i','a',' ','f','o','c','i',' ',':',' ','y',' ','=',' ','-','x','/','a',',',' ','z',' ','=',' ','x','/','a',' ','w','h','e','n',' ','b',' ','=',' ','x','*','(','c',' ','-',' ','x',')','/','a','\n',
    ' ',' ','m','a','t','r','i','x',' ','f','o','c','i',' ','=',' ','0',',',' ','-','1',',',' ','-','1',';',' ','1',',',' ','a',',',' ','0',';',' ','x','/','a',',',' ','0',',',' ','x',' ','-',' ','c','\n',
    ' ',' ','t','r','a','c','e',' ','f','o','c','i',' ','=',' ','a',' ','+',' ','x',' ','-',' ','c','\n',
    '\0'
};

const jlt_claim jlt_claims_roessler[] = {
    { "equilibria", "foci", "b = x*(c - x)/a", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "matrix", "foci", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "trace", "foci", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { NULL, NULL, NULL, JLT_UNSETTLED, NULL, NULL, NULL, NULL, NULL }
};

extern const jlt_descriptor jlt_kernels_roessler_general;

const jlt_descriptor *const jlt_family_roessler[] = {
    &jlt_kernels_roessler_general,
    NULL
};
