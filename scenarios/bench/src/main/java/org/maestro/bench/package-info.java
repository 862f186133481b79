/**
 * Benchmarks: large homes made to order, measurements on whole sites, and bare baselines beside
 * them in the same run. A size flows in, rows of figures flow out. Only here may a library be used
 * bare, as what ours is compared with. Nothing else may depend on it but the command line.
 */
@NullMarked
package org.maestro.bench;

import org.jspecify.annotations.NullMarked;
