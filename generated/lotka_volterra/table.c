/* lotka_volterra: its table byte for byte (SHA-256 74bd0797ba37376d0028cd3ec35e564e70e4bcb97d50e051e73f40b6925219f8), what is proved of it, its descriptors. Written by ttc 0.1.0; do not edit. */
#include "kernel_abi.h"

extern const char jlt_table_lotka_volterra[];
extern const jlt_claim jlt_claims_lotka_volterra[];
extern const jlt_descriptor *const jlt_family_lotka_volterra[];

const char jlt_table_lotka_volterra[] = {
    '#',' ','P','r','e','y',' ','a','n','d',' ','p','r','e','d','a','t','o','r',',',' ','w','i','t','h',' ','t','h','e',' ','e','x','p','o','n','e','n','t','i','a','l','s',' ','a','n','d',' ','l','o','g','a','r','i','t','h','m','s',' ','t','h','a','t',' ','i','t','s',' ','i','n','t','e','g','r','a','l',' ','a','n','d',' ','i','t','s',' ','n','a','t','u','r','a','l',' ','c','o','o','r','d','i','n','a','t','e','s',' ','n','e','e','d','.','\n',
    '\n',
    'm','o','d','e','l',' ','l','o','t','k','a','_','v','o','l','t','e','r','r','a','\n',
    't','i','t','l','e',' ','"','L','o','t','k','a','-','V','o','l','t','e','r','r','a',' ','e','q','u','a','t','i','o','n','s','"','\n',
    's','o','u','r','c','e',' ','"','V','.',' ','V','o','l','t','e','r','r','a',',',' ','V','a','r','i','a','z','i','o','n','i',' ','e',' ','f','l','u','t','t','u','a','z','i','o','n','i',' ','d','e','l',' ','n','u','m','e','r','o',' ','d','\'','i','n','d','i','v','i','d','u','i',' ','i','n',' ','s','p','e','c','i','e',' ','a','n','i','m','a','l','i',' ','c','o','n','v','i','v','e','n','t','i',',',' ','M','e','m','.',' ','A','c','a','d','.',' ','L','i','n','c','e','i',' ','R','o','m','a','"','\n',
    ' ',' ',' ',' ',' ',' ',' ','"','2',' ','(','1','9','2','6',')',' ','3','1','-','1','1','3','"','\n',
    '\n',
    'p','a','r','a','m',' ','a',' ','>',' ','0',' ','"','g','r','o','w','t','h',' ','o','f',' ','t','h','e',' ','p','r','e','y','"','\n',
    'p','a','r','a','m',' ','b',' ','>',' ','0',' ','"','p','r','e','y',' ','l','o','s','t',' ','t','o',' ','e','a','c','h',' ','p','r','e','d','a','t','o','r','"','\n',
    'p','a','r','a','m',' ','c',' ','>',' ','0',' ','"','d','e','a','t','h',' ','o','f',' ','p','r','e','d','a','t','o','r','s','"','\n',
    'p','a','r','a','m',' ','d',' ','>',' ','0',' ','"','p','r','e','d','a','t','o','r','s',' ','g','a','i','n','e','d',' ','b','y',' ','e','a','c','h',' ','p','r','e','y','"','\n',
    'd','e','f','a','u','l','t',' ','a',' ','=',' ','2','/','3',',',' ','b',' ','=',' ','4','/','3',',',' ','c',' ','=',' ','1',',',' ','d',' ','=',' ','1','\n',
    '\n',
    's','t','a','t','e',' ','x',' ','i','n',' ','(','0',',',' ','i','n','f',')',' ','"','p','r','e','y','"','\n',
    's','t','a','t','e',' ','y',' ','i','n',' ','(','0',',',' ','i','n','f',')',' ','"','p','r','e','d','a','t','o','r','s','"','\n',
    'l','o','g',' ','u',' ','=',' ','l','o','g','(','x',')','\n',
    'l','o','g',' ','v',' ','=',' ','l','o','g','(','y',')','\n',
    'l','e','t',' ','g',' ','=',' ','a',' ','-',' ','b','*','y','\n',
    'l','e','t',' ','h',' ','=',' ','d','*','x',' ','-',' ','c','\n',
    '\n',
    'e','q',' ','x',' ','=','\n',
    ' ',' ',' ',' ','+',' ','x','*','g','\n',
    'e','q',' ','y',' ','=','\n',
    ' ',' ',' ',' ','+',' ','y','*','h','\n',
    '\n',
    'i','n','t','e','g','r','a','l',' ','H',' ','=',' ','d','*','x',' ','-',' ','c','*','u',' ','+',' ','b','*','y',' ','-',' ','a','*','v','\n',
    'm','e','a','s','u','r','e',' ','r','h','o',' ','=',' ','1','/','(','x','*','y',')','\n',
    'r','a','t','e',' ','d','r','i','f','t',' ',':',' ','u',' ','-',' ','v',' ','=',' ','g',' ','-',' ','h','\n',
    'r','e','v','e','r','s','o','r',' ','x',' ','-','>',' ','y',',',' ','y',' ','-','>',' ','x',' ','w','h','e','n',' ','c',' ','=',' ','a',',',' ','d',' ','=',' ','b','\n',
    'e','q','u','i','l','i','b','r','i','a',' ','c','o','e','x','i','s','t','e','n','c','e',' ',':',' ','x',' ','=',' ','c','/','d',',',' ','y',' ','=',' ','a','/','b','\n',
    ' ',' ','m','a','t','r','i','x',' ','c','o','e','x','i','s','t','e','n','c','e',' ','=',' ','0',',',' ','-','b','*','c','/','d',';',' ','a','*','d','/','b',',',' ','0','\n',
    ' ',' ','c','h','a','r','p','o','l','y',' ','c','o','e','x','i','s','t','e','n','c','e',' ','=',' ','l','a','m','b','d','a','^','2',' ','+',' ','a','*','c','\n',
    '\0'
};

const jlt_claim jlt_claims_lotka_volterra[] = {
    { "integral", "H", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "measure", "rho", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "rate", "drift", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "reversor", "reversor", "c = a, d = b", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "equilibria", "coexistence", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "matrix", "coexistence", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "charpoly", "coexistence", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "log", "u", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "log", "v", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { NULL, NULL, NULL, JLT_UNSETTLED, NULL, NULL, NULL, NULL, NULL }
};

extern const jlt_descriptor jlt_kernels_lotka_volterra_general;

const jlt_descriptor *const jlt_family_lotka_volterra[] = {
    &jlt_kernels_lotka_volterra_general,
    NULL
};
