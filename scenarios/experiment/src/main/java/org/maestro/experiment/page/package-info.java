/**
 * The page of an experiment: one HTML file that needs nothing else, with paper and measurement side
 * by side, figures, assumptions, and an explanation of each failure. Findings flow in, text flows
 * out.
 */
@NullMarked
package org.maestro.experiment.page;

import org.jspecify.annotations.NullMarked;
