/**
 * The papers' experiments, each one command: a number of runs in the simulated world, raw data of
 * every run, figures, and a page that shows paper and measurement side by side. How many runs and
 * from which seed flow in, findings flow out. Nothing here is tuned to the papers' figures.
 */
@NullMarked
package org.maestro.experiment;

import org.jspecify.annotations.NullMarked;
