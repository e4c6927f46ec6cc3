/* The same calls of library/rasterproof_rasterize.h, compiled as C99 and as C++11. */
#ifndef RASTERPROOF_TESTS_LIBRARY_RASTERIZE_LANGUAGES_H_
#define RASTERPROOF_TESTS_LIBRARY_RASTERIZE_LANGUAGES_H_

#ifdef __cplusplus
extern "C" {
#endif

/* 0, or the number of the first check that failed: see rasterize_calls.inc. */
int rasterproof_calls_of_c99(void);
int rasterproof_calls_of_cxx11(void);

#ifdef __cplusplus
}
#endif

#endif /* RASTERPROOF_TESTS_LIBRARY_RASTERIZE_LANGUAGES_H_ */
