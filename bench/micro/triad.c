/* a = b + s c over arrays beyond every cache, by as many threads as OMP_NUM_THREADS says: what memory gives.
 *
 *   triad SECONDS        prints GB/s, the best of the passes made in that time
 */
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

enum { size = 20000000 };  // three arrays of 160 MB

int main(int count, char** words) {
  const double seconds = count > 1 ? atof(words[1]) : 1;
  double *a = malloc(sizeof(double) * size), *b = malloc(sizeof(double) * size), *c = malloc(sizeof(double) * size);
  if (!a || !b || !c) return 1;
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) a[i] = 0, b[i] = i, c[i] = 1;
  double best = 0;
  for (const double end = omp_get_wtime() + seconds; omp_get_wtime() < end;) {
    const double begin = omp_get_wtime();
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i) a[i] = b[i] + 0.5 * c[i];
    const double rate = 3e-9 * sizeof(double) * size / (omp_get_wtime() - begin);
    if (rate > best) best = rate;
  }
  printf("%.3f\n", best);
  return a[size / 2] > 0 ? 0 : 1;
}
