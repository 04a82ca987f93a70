/* nose_hoover: its table byte for byte (SHA-256 0e94aea4c9b2928c9741d0c1ca85c73ce0d4c8f4262b18320c66e53d04de6370), what is proved of it, its descriptors. Written by ttc 0.1.0; do not edit. */
#include "kernel_abi.h"

extern const char jlt_table_nose_hoover[];
extern const jlt_claim jlt_claims_nose_hoover[];
extern const jlt_descriptor *const jlt_family_nose_hoover[];

const char jlt_table_nose_hoover[] = {
    '#',' ','O','n','e',' ','h','a','r','m','o','n','i','c',' ','o','s','c','i','l','l','a','t','o','r',' ','w','i','t','h',' ','a',' ','t','h','e','r','m','o','s','t','a','t',':',' ','t','h','e',' ','c','a','n','o','n','i','c','a','l',' ','d','e','n','s','i','t','y',' ','i','s',' ','i','n','v','a','r','i','a','n','t',',',' ','n','o','r','m','a','l','i','z','e','d',' ','b','y',' ','a',' ','p','o','w','e','r',' ','o','f',' ','2',' ','p','i','.','\n',
    '\n',
    'm','o','d','e','l',' ','n','o','s','e','_','h','o','o','v','e','r','\n',
    't','i','t','l','e',' ','"','N','o','s','e','-','H','o','o','v','e','r',' ','o','s','c','i','l','l','a','t','o','r','"','\n',
    's','o','u','r','c','e',' ','"','W','.',' ','G','.',' ','H','o','o','v','e','r',',',' ','C','a','n','o','n','i','c','a','l',' ','d','y','n','a','m','i','c','s',':',' ','e','q','u','i','l','i','b','r','i','u','m',' ','p','h','a','s','e','-','s','p','a','c','e',' ','d','i','s','t','r','i','b','u','t','i','o','n','s',',',' ','P','h','y','s','.',' ','R','e','v','.',' ','A',' ','3','1',' ','(','1','9','8','5',')',' ','1','6','9','5','-','1','6','9','7','"','\n',
    '\n',
    'p','a','r','a','m',' ','T',' ','>',' ','0',' ','"','t','e','m','p','e','r','a','t','u','r','e','"','\n',
    'p','a','r','a','m',' ','Q',' ','>',' ','0',' ','"','i','n','e','r','t','i','a',' ','o','f',' ','t','h','e',' ','t','h','e','r','m','o','s','t','a','t','"','\n',
    'd','e','f','a','u','l','t',' ','T',' ','=',' ','1',',',' ','Q',' ','=',' ','1','\n',
    '\n',
    's','t','a','t','e',' ','q',' ','"','p','o','s','i','t','i','o','n','"','\n',
    's','t','a','t','e',' ','p',' ','"','m','o','m','e','n','t','u','m','"','\n',
    's','t','a','t','e',' ','z',' ','"','f','r','i','c','t','i','o','n','"','\n',
    'l','e','t',' ','H',' ','=',' ','(','q','^','2',' ','+',' ','p','^','2',' ','+',' ','Q','*','z','^','2',')','/','2','\n',
    'r','o','o','t',' ','n',' ','=',' ','s','q','r','t','(','2','*','p','i','*','T',')','\n',
    'r','o','o','t',' ','m',' ','=',' ','s','q','r','t','(','Q',')','\n',
    'e','x','p',' ','w',' ','=',' ','e','x','p','(','-','H','/','T',')','\n',
    '\n',
    'e','q',' ','q',' ','=','\n',
    ' ',' ',' ',' ','+',' ','p','\n',
    'e','q',' ','p',' ','=','\n',
    ' ',' ',' ',' ','-',' ','q','\n',
    ' ',' ',' ',' ','-',' ','z','*','p','\n',
    'e','q',' ','z',' ','=','\n',
    ' ',' ',' ',' ','+',' ','(','p','^','2',' ','-',' ','T',')','/','Q','\n',
    '\n',
    'm','e','a','s','u','r','e',' ','c','a','n','o','n','i','c','a','l',' ','=',' ','m','*','w','/','n','^','3','\n',
    'r','a','t','e',' ','h','e','a','t',' ',':',' ','H',' ','=',' ','-','T','*','z','\n',
    'r','a','t','e',' ','w','e','i','g','h','t',' ',':',' ','w',' ','=',' ','z','*','w','\n',
    'r','e','v','e','r','s','o','r',' ','p',' ','-','>',' ','-','p',',',' ','z',' ','-','>',' ','-','z','\n',
    's','y','m','m','e','t','r','y',' ','q',' ','-','>',' ','-','q',',',' ','p',' ','-','>',' ','-','p','\n',
    '\0'
};

const jlt_claim jlt_claims_nose_hoover[] = {
    { "measure", "canonical", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "rate", "heat", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "rate", "weight", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "reversor", "reversor", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "symmetry", "symmetry", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "root", "n", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { "root", "m", "", JLT_PROVED, "", NULL, NULL, NULL, NULL },
    { NULL, NULL, NULL, JLT_UNSETTLED, NULL, NULL, NULL, NULL, NULL }
};

extern const jlt_descriptor jlt_kernels_nose_hoover_general;

const jlt_descriptor *const jlt_family_nose_hoover[] = {
    &jlt_kernels_nose_hoover_general,
    NULL
};
