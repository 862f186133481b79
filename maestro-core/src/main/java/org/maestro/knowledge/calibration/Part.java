package org.maestro.knowledge.calibration;

import org.maestro.sl.Expression;

/**
 * A part of a measured number.
 *
 * @param share its fluent, {@code (gain lamp-b1 zone-b)}
 * @param setting {@code (level lamp-b1)}
 * @param stated what the share is as stated or computed; not 0
 */
record Part(Expression.Fluent share, Expression.Fluent setting, double stated) {}
