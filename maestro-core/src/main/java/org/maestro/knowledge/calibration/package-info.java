/**
 * What a setting gives to a number that is measured, learnt from measurements: how bright a lamp
 * really is where a sensor stands. Results of features flow in; numbers that are otherwise than
 * stated flow back as facts, and for places without a sensor what follows from them. It does not
 * know what is measured: the home's words say so ({@code maestro:shareOf}).
 */
@NullMarked
package org.maestro.knowledge.calibration;

import org.jspecify.annotations.NullMarked;
