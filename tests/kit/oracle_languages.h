/* The same calls of kit/rasterproof_oracle.h, compiled as C99 and as C++11. */
#ifndef RASTERPROOF_TESTS_KIT_ORACLE_LANGUAGES_H_
#define RASTERPROOF_TESTS_KIT_ORACLE_LANGUAGES_H_

#ifdef __cplusplus
extern "C" {
#endif

/* How many of the checks of oracle_calls.inc failed. */
int rasterproof_oracle_calls_of_c99(void);
int rasterproof_oracle_calls_of_cxx11(void);

#ifdef __cplusplus
}
#endif

#endif /* RASTERPROOF_TESTS_KIT_ORACLE_LANGUAGES_H_ */
