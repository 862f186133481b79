/**
 * The figures of experiments. Numbers flow in, PNG images flow out. All share one style: axes with
 * units, labelled lines, colours that colour-blind people can tell apart, letters that stay legible
 * at half the size.
 */
@NullMarked
package org.maestro.experiment.drawing;

import org.jspecify.annotations.NullMarked;
